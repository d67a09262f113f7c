// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/pose.hpp"
#include "costmap/alignability_map.hpp"
#include "costmap/bilinear_field.hpp"
#include "costmap/occupancy_map.hpp"
#include "costmap/risk_source.hpp"

namespace alignability {

struct RiskOptions {
  double alpha_critical = 0.1;  ///< risk 1 at or below; in [0, alpha_safe)
  double alpha_safe = 0.4;      ///< risk 0 at or above; in (alpha_critical, 1]
  UnknownPolicy unknown = UnknownPolicy::risky;
  std::optional<double> min_alpha = {};  ///< a floor in [0, 1]: where α is less, or has no value, the robot may not be
  double alpha_weight = 1.0;             ///< what α's own risk counts in the sum of risks, >= 0
  std::vector<RiskSource> sources = {};  ///< what else is risky
};

/// `alignability`, then the sources' names.
std::vector<std::string> names_of_risks(const RiskOptions& options);

/// One of the risks that add up: in [0,1], bilinear between the nodes of a grid of its own.
struct RiskLayer {
  std::string name;
  double weight = 1.0;
  BilinearField risk;
};

/// What is risky by place, and α itself. The risk of losing localization is in [0,1] and, like α, bilinear between the centres of α-cells;
/// with further sources it is a sum, Σ weight·risk, which may exceed 1. Each term is bilinear on a grid of its own, so that no sum
/// is ever resampled. A cell without a value that borders evaluated ones takes, for interpolation, the mean of those that it reaches
/// through free cells (see fill_border). Immutable, safe to read from many threads, queries allocate nothing.
class RiskField {
 public:
  /// Throws std::invalid_argument for thresholds and weights out of range, and for sources with a fault (see fault_of_source).
  RiskField(const AlignabilityMap& map, const OccupancyMap& occupancy, const RiskOptions& options);

  const RiskOptions& options() const { return options_; }
  /// The same field with another floor, or none.
  RiskField with_floor(std::optional<double> min_alpha) const;

  /// A field of one layer takes no notice of yaw.
  double risk(double x, double y, double yaw) const;
  /// ∫ risk ds [m] along the straight segment between two poses; exact, the same to the bit in either direction.
  double integral(const Pose2& from, const Pose2& to) const {
    return sum([&](const BilinearField& risk) { return risk.integral(from.position(), to.position()); });
  }
  /// The same along an arc, to 1e-9 of its length.
  double integral(const Arc& arc) const {
    return sum([&](const BilinearField& risk) { return risk.integral(arc); });
  }
  /// NaN where a cell without a value has a part in it.
  double alpha(double x, double y, double yaw) const;
  /// Whether α is below alpha_critical, or unknown under a policy that takes the unknown for risky.
  bool is_blind(double alpha) const;
  /// Whether policy and floor let the robot's centre be there, and at every point of the segment or arc; exact.
  bool is_drivable(const Eigen::Vector2d& point) const;
  bool is_drivable(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const;
  bool is_drivable(const Arc& arc) const;

  /// What the risk is the sum of, α's first. What weighs nothing is among them.
  const std::vector<RiskLayer>& layers() const { return layers_; }
  const BilinearField& alpha_layer() const { return alpha_; }

 private:
  bool has_value(Cell cell) const;

  template <typename Value>
  double sum(Value value_of) const {
    if (is_alpha_alone_) return value_of(layers_.front().risk);
    double sum = 0.0;
    for (const RiskLayer& layer : layers_) {
      if (layer.weight != 0.0) sum += layer.weight * value_of(layer.risk);
    }
    return sum;
  }

  RiskOptions options_;
  BilinearField alpha_;
  std::vector<RiskLayer> layers_;
  bool is_alpha_alone_ = true;  // nothing else weighs anything, and α weighs 1
};

/// α with the cells filled that have none but border cells that have: the mean over those of the eight neighbours which free cells
/// of the occupancy map connect to it within the 3 × 3 cells around. A cell that is all wall takes the side whose mean is lowest, so
/// that a wall between a poor place and a rich one hides neither.
Grid<double> fill_border(const Grid<float>& alpha, const OccupancyMap& occupancy);

}  // namespace alignability
