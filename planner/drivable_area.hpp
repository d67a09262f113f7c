// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "costmap/clearance_map.hpp"
#include "costmap/risk_field.hpp"

namespace alignability {

/// A robot as a disk around `base_link`.
struct Robot {
  double radius = 0.0;  ///< [m], > 0
};

/// Where a robot may be: free of obstacles, exactly, and not where RiskField blocks the unknown. Cheap to copy, safe to read from
/// many threads.
class DrivableArea {
 public:
  DrivableArea(std::shared_ptr<const ClearanceMap> clearance, std::shared_ptr<const RiskField> risk, const Robot& robot);

  bool contains(const Pose2& pose) const;
  /// Whether it contains every pose on the straight way; the robot may turn on it as it likes. No sampling: a wall of one thin cell
  /// is never passed.
  bool contains(const Pose2& from, const Pose2& to) const;
  /// [m] between the robot's edge and the nearest obstacle; negative in collision.
  double clearance(const Pose2& pose) const;
  /// False only if no path leads from one to within `tolerance` [m] of the other: a proof, by flooding every cell in which some
  /// point could hold the robot. O(cells).
  bool may_connect(const Pose2& from, const Pose2& to, double tolerance) const;

  const GridGeometry& geometry() const { return clearance_->geometry(); }

 private:
  std::shared_ptr<const ClearanceMap> clearance_;
  std::shared_ptr<const RiskField> risk_;
  Robot robot_;
};

}  // namespace alignability
