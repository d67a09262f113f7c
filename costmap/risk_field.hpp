// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "core/pose.hpp"
#include "costmap/alignability_map.hpp"
#include "costmap/bilinear_field.hpp"
#include "costmap/occupancy_map.hpp"

namespace alignability {

/// What a place is worth whose alignability nobody knows.
enum class UnknownPolicy {
  risky,    ///< risk 1, and blind
  neutral,  ///< risk 0, and not blind
  blocked,  ///< not drivable; risk 1 where asked all the same
};

struct RiskOptions {
  double alpha_critical = 0.1;  ///< risk 1 at or below; in [0, alpha_safe)
  double alpha_safe = 0.4;      ///< risk 0 at or above; in (alpha_critical, 1]
  UnknownPolicy unknown = UnknownPolicy::risky;
  std::optional<double> min_alpha = {};  ///< a floor in [0, 1]: where α is less, or has no value, the robot may not be
};

/// The risk of losing localization, by place, in [0,1], and α itself: both bilinear between the centres of α-cells. A cell without
/// a value that borders evaluated ones takes, for interpolation, the mean of those that it reaches through free cells (see fill_border).
/// Immutable, safe to read from many threads, queries allocate nothing.
class RiskField {
 public:
  /// Throws std::invalid_argument for thresholds out of range.
  RiskField(const AlignabilityMap& map, const OccupancyMap& occupancy, const RiskOptions& options);

  const RiskOptions& options() const { return options_; }
  /// The same field with another floor, or none.
  RiskField with_floor(std::optional<double> min_alpha) const;

  /// A field of one layer takes no notice of yaw.
  double risk(double x, double y, double yaw) const;
  /// ∫ risk ds [m] along the straight segment between two poses; exact, the same to the bit in either direction.
  double integral(const Pose2& from, const Pose2& to) const { return risk_.integral(from.position(), to.position()); }
  /// The same along an arc, to 1e-9 of its length.
  double integral(const Arc& arc) const { return risk_.integral(arc); }
  /// NaN where a cell without a value has a part in it.
  double alpha(double x, double y, double yaw) const;
  /// Whether α is below alpha_critical, or unknown under a policy that takes the unknown for risky.
  bool is_blind(double alpha) const;
  /// Whether policy and floor let the robot's centre be there, and at every point of the segment or arc; exact.
  bool is_drivable(const Eigen::Vector2d& point) const;
  bool is_drivable(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const;
  bool is_drivable(const Arc& arc) const;

  const BilinearField& risk_layer() const { return risk_; }
  const BilinearField& alpha_layer() const { return alpha_; }

 private:
  bool has_value(Cell cell) const;

  RiskOptions options_;
  BilinearField alpha_;
  BilinearField risk_;
};

/// α with the cells filled that have none but border cells that have: the mean over those of the eight neighbours which free cells
/// of the occupancy map connect to it within the 3 × 3 cells around. A cell that is all wall takes the side whose mean is lowest, so
/// that a wall between a poor place and a rich one hides neither.
Grid<double> fill_border(const Grid<float>& alpha, const OccupancyMap& occupancy);

}  // namespace alignability
