// SPDX-License-Identifier: BSD-3-Clause
#include "planner/pose_goal.hpp"

#include <ompl/base/SpaceInformation.h>

#include <algorithm>

#include "planner/poses.hpp"

namespace alignability {
namespace ob = ompl::base;

PoseGoal::PoseGoal(const ob::SpaceInformationPtr& si, const Pose2& pose, const GoalTolerance& tolerance)
    : ob::GoalSampleableRegion(si),
      pose_(pose),
      tolerance_(tolerance),
      projection_(projection_of(si->getStateSpace())),
      has_heading_(has_heading(*si->getStateSpace())) {
  setThreshold(tolerance.position);
}

double PoseGoal::distanceGoal(const ob::State* state) const {
  const Pose2 at = projection_(state);
  const double position = (at.position() - pose_.position()).norm();
  if (!has_heading_) return position;
  const double heading = std::abs(normalized_angle(at.yaw - pose_.yaw));
  return std::max(position, heading * tolerance_.position / tolerance_.heading);
}

bool PoseGoal::isSatisfied(const ob::State* state) const { return distanceGoal(state) <= tolerance_.position; }

bool PoseGoal::isSatisfied(const ob::State* state, double* distance) const {
  const double from_goal = distanceGoal(state);
  if (distance != nullptr) *distance = from_goal;
  return from_goal <= tolerance_.position;
}

void PoseGoal::sampleGoal(ob::State* state) const { set_pose(*si_->getStateSpace(), pose_, state); }

}  // namespace alignability
