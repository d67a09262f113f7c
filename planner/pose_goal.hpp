// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ompl/base/goals/GoalSampleableRegion.h>

#include "planner/state_projection.hpp"

namespace alignability {

struct GoalTolerance {
  double position = 0.1;         ///< [m], > 0
  double heading = radians(10);  ///< [rad], > 0; R² has no heading to hold
};

/// All states whose pose is within the tolerance of one. Samples are that pose itself, so that planners that need a goal state aim at
/// the middle; a tree that gets near enough is done all the same.
class PoseGoal : public ompl::base::GoalSampleableRegion {
 public:
  /// In R² or SE(2).
  PoseGoal(const ompl::base::SpaceInformationPtr& si, const Pose2& pose, const GoalTolerance& tolerance);

  const Pose2& pose() const { return pose_; }
  const GoalTolerance& tolerance() const { return tolerance_; }

  /// [m]; at most the position's tolerance exactly where both tolerances are met.
  double distanceGoal(const ompl::base::State* state) const override;
  bool isSatisfied(const ompl::base::State* state) const override;
  bool isSatisfied(const ompl::base::State* state, double* distance) const override;
  void sampleGoal(ompl::base::State* state) const override;
  unsigned int maxSampleCount() const override { return 1; }

 private:
  Pose2 pose_;
  GoalTolerance tolerance_;
  StateProjection projection_;
  bool has_heading_;
};

}  // namespace alignability
