// SPDX-License-Identifier: BSD-3-Clause
#include "planner/state_projection.hpp"

#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/util/Exception.h>

namespace alignability {
namespace ob = ompl::base;

StateProjection projection_of(const ob::StateSpacePtr& space) {
  if (dynamic_cast<const ob::SE2StateSpace*>(space.get()) != nullptr) {
    return [](const ob::State* state) {
      const auto* pose = state->as<ob::SE2StateSpace::StateType>();
      return Pose2{pose->getX(), pose->getY(), pose->getYaw()};
    };
  }
  if (dynamic_cast<const ob::RealVectorStateSpace*>(space.get()) != nullptr && space->getDimension() == 2) {
    return [](const ob::State* state) {
      const double* values = state->as<ob::RealVectorStateSpace::StateType>()->values;
      return Pose2{values[0], values[1], 0.0};
    };
  }
  throw ompl::Exception("projection_of", "no projection is known for the state space '" + space->getName() + "': give one");
}

}  // namespace alignability
