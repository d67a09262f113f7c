// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/pose.hpp"
#include "costmap/alignability_map.hpp"
#include "costmap/bilinear_field.hpp"
#include "costmap/heading_field.hpp"
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
  BilinearField risk;          ///< of what depends on heading, node by node at the best of the map's headings: nowhere above it
  HeadingField headings = {};  ///< empty of what takes no notice of yaw

  double at(const Pose2& pose) const { return headings.empty() ? risk.at(pose.position()) : headings.at(pose); }
  double integral(const Pose2& from, const Pose2& to) const {
    return headings.empty() ? risk.integral(from.position(), to.position()) : headings.integral(from, to);
  }
  double integral(const Arc& arc) const { return headings.empty() ? risk.integral(arc) : headings.integral(arc); }
};

/// What is risky by place, and α itself. The risk of losing localization is in [0,1] and, like α, bilinear between the centres of α-cells;
/// with further sources it is a sum, Σ weight·risk, which may exceed 1. Each term is bilinear on a grid of its own, so that no sum
/// is ever resampled. A cell without a value that borders evaluated ones takes, for interpolation, the mean of those that it reaches
/// through free cells (see fill_border). Immutable, safe to read from many threads, queries allocate nothing.
///
/// A map with layers by heading (see heading_layers) makes α and its risk depend on yaw: linear between the two nearest headings. A cell
/// without a value at one heading has none at any.
class RiskField {
 public:
  /// Throws std::invalid_argument for thresholds and weights out of range, and for sources with a fault (see fault_of_source).
  RiskField(const AlignabilityMap& map, const OccupancyMap& occupancy, const RiskOptions& options);

  const RiskOptions& options() const { return options_; }
  /// The same field with another floor, or none.
  RiskField with_floor(std::optional<double> min_alpha) const;

  /// Whether it depends on yaw. Where it does not, yaws have no part in what follows.
  bool has_headings() const { return !alpha_headings_.empty(); }
  double risk(double x, double y, double yaw) const;
  /// ∫ risk ds [m] along the straight segment between two poses, yaw turning evenly the shorter way around; exact, the same to the bit in
  /// either direction.
  double integral(const Pose2& from, const Pose2& to) const {
    return sum([&](const RiskLayer& layer) { return layer.integral(from, to); });
  }
  /// The same along an arc, which a robot driving backward faces away from, to 1e-9 of its length.
  double integral(const Arc& arc) const {
    return sum([&](const RiskLayer& layer) { return layer.integral(arc); });
  }
  /// NaN where a cell without a value has a part in it.
  double alpha(double x, double y, double yaw) const;
  /// Whether α is below alpha_critical, or unknown under a policy that takes the unknown for risky.
  bool is_blind(double alpha) const;

  /// Whether policy and floor let the robot's centre be there, facing so, and at every point of the segment or arc; exact.
  bool is_drivable_at(const Pose2& pose) const;
  bool is_drivable_along(const Pose2& from, const Pose2& to) const;
  bool is_drivable(const Arc& arc) const;
  /// The same for some heading at each point, whichever it is there.
  bool is_drivable(const Eigen::Vector2d& point) const;
  bool is_drivable(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const;

  /// Node by node at the best of the map's headings: what the risk is at least, and α at most, at any heading; the values themselves where
  /// there are no headings. Of the best field the integral and α are those of a plain field.
  double least_risk(const Eigen::Vector2d& point) const;
  double least_integral(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const {
    return sum([&](const RiskLayer& layer) { return layer.risk.integral(from, to); });
  }
  double greatest_alpha(const Eigen::Vector2d& point) const { return alpha_.at(point); }
  /// The field of these values, which takes no notice of yaw.
  RiskField best_over_headings() const;

  /// What the risk is the sum of, α's first. What weighs nothing is among them.
  const std::vector<RiskLayer>& layers() const { return layers_; }
  /// α, of a map with headings node by node at the best of them.
  const BilinearField& alpha_layer() const { return alpha_; }
  /// α by heading; empty where it takes no notice of yaw.
  const HeadingField& alpha_headings() const { return alpha_headings_; }

 private:
  bool has_value(Cell cell) const;
  bool is_known(const Eigen::Vector2d& point) const;
  bool is_known_between(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const;

  template <typename Value>
  double sum(Value value_of) const {
    if (is_alpha_alone_) return value_of(layers_.front());
    double sum = 0.0;
    for (const RiskLayer& layer : layers_) {
      if (layer.weight != 0.0) sum += layer.weight * value_of(layer);
    }
    return sum;
  }

  RiskOptions options_;
  BilinearField alpha_;
  HeadingField alpha_headings_;
  std::vector<RiskLayer> layers_;
  bool is_alpha_alone_ = true;  // nothing else weighs anything, and α weighs 1
};

/// α with the cells filled that have none but border cells that have: the mean over those of the eight neighbours which free cells
/// of the occupancy map connect to it within the 3 × 3 cells around. A cell that is all wall takes the side whose mean is lowest, so
/// that a wall between a poor place and a rich one hides neither.
Grid<double> fill_border(const Grid<float>& alpha, const OccupancyMap& occupancy);

}  // namespace alignability
