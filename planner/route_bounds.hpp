// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "planner/cost_bound.hpp"
#include "planner/drivable_area.hpp"
#include "planner/pose_goal.hpp"

namespace alignability {

/// Certified lower bounds of the cost of a robot's ways from one start to one goal, and with them the informed set: where a path can pass
/// that costs less than another. Immutable, safe to read from many threads.
class RouteBounds {
 public:
  /// For ∫ (1 + weight·risk) ds. O(cells · log cells).
  RouteBounds(const DrivableArea& area, double weight, const Eigen::Vector2d& start, const Eigen::Vector2d& goal, double tolerance);

  /// At most what getting within the goal's tolerance costs from there; infinite where nothing leads, and where the robot cannot be.
  double to_goal(const Eigen::Vector2d& point) const { return to_goal_(point); }
  /// At most what a path from the start to the goal costs that passes there; infinite likewise.
  double through(const Eigen::Vector2d& point) const { return from_start_(point) + to_goal_(point); }
  /// At most what getting from one place to another costs: what the two bounds differ by. Admissible, consistent, symmetric; infinite
  /// where one is cut off from start and goal and the other is not.
  double between(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const;
  /// The cells through which a path below a cost may pass, their number first to last; they are the first of `cell()`. O(log cells).
  std::size_t cells_below(double cost) const;
  /// The square of one of them [m].
  Eigen::AlignedBox2d cell(std::size_t rank) const;

 private:
  struct Ranked {
    float least;  // of through(), rounded down
    std::uint32_t cell;
  };

  CostBound from_start_;
  CostBound to_goal_;
  std::vector<Ranked> ranked_;
};

}  // namespace alignability
