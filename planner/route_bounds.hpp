// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/progress.hpp"
#include "planner/cost_bound.hpp"
#include "planner/drivable_area.hpp"
#include "planner/pose_goal.hpp"

namespace alignability {

/// Certified lower bounds of the cost of a robot's ways from one start to one goal, and with them the informed set: where a path can pass
/// that costs less than another. Immutable, safe to read from many threads.
class RouteBounds {
 public:
  /// For ∫ (1 + weight·risk) ds. O(cells), in two threads. `stop` is asked by both at once. Throws Interrupted.
  RouteBounds(const DrivableArea& area, double weight, const Eigen::Vector2d& start, const Eigen::Vector2d& goal, double tolerance,
              const StopTest& stop = {});

  /// At most what getting within the goal's tolerance costs from there; infinite where nothing leads, and where the robot cannot be.
  double to_goal(const Eigen::Vector2d& point) const { return to_goal_(point); }
  /// At most what a path from the start to the goal costs that passes there; infinite likewise.
  double through(const Eigen::Vector2d& point) const { return from_start_(point) + to_goal_(point); }
  /// At most what getting from one place to another costs: what the two bounds differ by. Admissible, consistent, symmetric; infinite
  /// where one is cut off from start and goal and the other is not.
  double between(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const;
  /// The number of cells through which a path below a cost may pass, and of a few more; they are the first of `cell()`. O(log cells).
  std::size_t cells_below(double cost) const;
  /// The square of one of them [m].
  Eigen::AlignedBox2d cell(std::size_t rank) const;

 private:
  struct Both {
    CostBound from_start;
    CostBound to_goal;
  };

  explicit RouteBounds(Both both);
  static Both both(const DrivableArea& area, double weight, const Eigen::Vector2d& start, const Eigen::Vector2d& goal, double tolerance,
                   const StopTest& stop);
  /// Of cells that are alike in what through() is at least; costs from the least on. Negative below that.
  double class_of(double cost) const { return std::floor((cost - least_) / width_); }

  CostBound from_start_;
  CostBound to_goal_;
  double least_ = 0.0;                // that through() is in any cell
  double width_ = 1.0;                // of a class
  std::vector<std::uint32_t> cells_;  // class after class
  std::vector<std::size_t> ends_;     // of the classes, among cells_
};

}  // namespace alignability
