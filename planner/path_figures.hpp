// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "costmap/risk_field.hpp"
#include "planner/curve.hpp"

namespace alignability {

/// What a path of straight segments or curves is worth, exactly: no sampling. Lengths in metres.
struct PathFigures {
  double length = 0.0;
  double turned = 0.0;            ///< ∫ |dyaw| [rad]
  double backward_length = 0.0;   ///< of curves: driven backward
  double risk_integral = 0.0;     ///< ∫ risk ds, of all sources, each as often as it weighs
  double blind_length = 0.0;      ///< where RiskField::is_blind
  double longest_blind = 0.0;     ///< the longest stretch without a break
  double evaluated_length = 0.0;  ///< where α has a value
  double alpha_mean = 0.0;        ///< by length, over evaluated places; NaN when there are none
  double alpha_min = 0.0;         ///< over evaluated places; NaN when there are none
  /// ∫ risk ds of each of RiskField::layers(), unweighted: the metres at its risk.
  std::vector<double> risk_by_source = {};
};

/// O(α-cells crossed).
PathFigures measure(std::span<const Pose2> path, const RiskField& risk);
/// Of curves that go on from one another.
PathFigures measure(std::span<const Curve> path, const RiskField& risk);

struct PathSample {
  Pose2 pose;
  double s = 0.0;      ///< arc length [m]
  double alpha = 0.0;  ///< NaN where not evaluated
  double risk = 0.0;
};

/// The path's own poses and as many between that none is further than `step` [m] from the next.
std::vector<PathSample> sample(std::span<const Pose2> path, const RiskField& risk, double step);

}  // namespace alignability
