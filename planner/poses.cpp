// SPDX-License-Identifier: BSD-3-Clause
#include "planner/poses.hpp"

#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>

#include <numbers>

namespace alignability {
namespace ob = ompl::base;

bool has_heading(const ob::StateSpace& space) { return dynamic_cast<const ob::SE2StateSpace*>(&space) != nullptr; }

void set_pose(const ob::StateSpace& space, const Pose2& pose, ob::State* state) {
  if (has_heading(space)) {
    auto* se2 = state->as<ob::SE2StateSpace::StateType>();
    se2->setXY(pose.x, pose.y);
    const double yaw = normalized_angle(pose.yaw);
    // To OMPL π itself is out of bounds.
    se2->setYaw(yaw < std::numbers::pi ? yaw : -std::numbers::pi);
    return;
  }
  double* values = state->as<ob::RealVectorStateSpace::StateType>()->values;
  values[0] = pose.x;
  values[1] = pose.y;
}

}  // namespace alignability
