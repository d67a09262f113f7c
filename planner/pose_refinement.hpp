// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/progress.hpp"
#include "planner/drivable_area.hpp"

namespace alignability {

/// What straight motions cost on which the robot turns evenly, and where they are allowed, both exactly.
struct PoseMotion {
  const DrivableArea& area;
  double weight = 0.0;     ///< of the risk, >= 0
  double turn_cost = 0.0;  ///< [m/rad], >= 0

  double cost(const Pose2& from, const Pose2& to) const;
  bool is_allowed(const Pose2& from, const Pose2& to) const { return area.contains(from, to); }
};

/// A path freed of the places and headings that it was found on: shortcuts, then poses moved, turned and added as long as that lowers the
/// exact cost. Begins and ends in the same poses, is allowed where it was, never costs more. Comes to an end early when
/// told to stop.
std::vector<Pose2> refined(std::vector<Pose2> path, const PoseMotion& motion, const StopTest& stop = {});

}  // namespace alignability
