// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>

#include "core/progress.hpp"
#include "costmap/clearance_map.hpp"
#include "costmap/risk_field.hpp"
#include "planner/curve.hpp"
#include "planner/footprint_sweep.hpp"
#include "planner/robot.hpp"

namespace alignability {

/// Where a robot may be: free of obstacles, exactly, and not where RiskField blocks the unknown. Cheap to copy, safe to read from
/// many threads.
class DrivableArea {
 public:
  /// Throws std::invalid_argument for a robot without a positive radius or a simple footprint.
  DrivableArea(std::shared_ptr<const ClearanceMap> clearance, std::shared_ptr<const RiskField> risk, const Robot& robot);

  bool contains(const Pose2& pose) const;
  /// Whether it contains some pose there of a robot that is a disk.
  bool contains_disk(const Eigen::Vector2d& place) const;
  /// Whether it contains every pose on the straight way, on which the robot turns evenly the shorter way around (a disk may turn as it
  /// likes, but for a floor of α where that depends on heading). No sampling: a wall of one thin cell is never passed.
  bool contains(const Pose2& from, const Pose2& to) const;
  /// Whether it contains every pose on the arc or curve itself: refused where the robot comes nearer to an obstacle than a thousandth of a
  /// cell, never allowed where it collides.
  bool contains(const Arc& arc) const;
  bool contains(const Curve& curve) const;
  /// [m] between the robot's edge and the nearest obstacle; in collision 0, of a disk negative.
  double clearance(const Pose2& pose) const;
  /// False only if no path leads from one to within `tolerance` [m] of the other: a proof, by flooding every cell in which some
  /// point could hold the largest disk within the robot. O(cells).
  bool may_connect(const Pose2& from, const Pose2& to, double tolerance, const StopTest& stop = {}) const;

  const GridGeometry& geometry() const { return clearance_->geometry(); }
  const std::shared_ptr<const ClearanceMap>& clearance_map() const { return clearance_; }
  const std::shared_ptr<const RiskField>& risk_field() const { return risk_; }
  /// Of the largest disk around `base_link` within the robot, and of the smallest that holds it [m]; one radius of a disk.
  double inscribed_radius() const { return inscribed_radius_; }
  double circumscribed_radius() const { return circumscribed_radius_; }

 private:
  std::shared_ptr<const ClearanceMap> clearance_;
  std::shared_ptr<const RiskField> risk_;
  double inscribed_radius_;
  double circumscribed_radius_;
  std::optional<FootprintSweep> sweep_;  // of a robot that is no disk
};

}  // namespace alignability
