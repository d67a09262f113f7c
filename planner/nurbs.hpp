// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "core/pose.hpp"

namespace alignability {

/// A non-uniform rational B-spline in the plane, as VDA 5050 and LIF give trajectories. Begins and ends at its first and last control
/// points where the first and last knots are repeated degree + 1 times.
struct Nurbs {
  struct ControlPoint {
    Eigen::Vector2d at = Eigen::Vector2d::Zero();  ///< [m]
    double weight = 1.0;
  };

  int degree = 1;
  std::vector<double> knots;  ///< degree + 1 more than points, none less than the one before
  std::vector<ControlPoint> points;
};

/// What is wrong with a curve, in a sentence; nullopt when it can be drawn: a degree from 1 to 32, weights from 1e-6 to 1e6, no
/// number beyond 1e9, no gaps.
std::optional<std::string> fault_of_nurbs(const Nurbs& curve);

/// Poses along a curve that has no fault, each with the curve's heading, between which straight lines stay within `tolerance` [m] of it.
/// Where it has a kink, two poses of one place. Empty for a curve of one point. Rounding allows no tolerance below 1e-12 of
/// the greatest coordinate.
std::vector<Pose2> flattened(const Nurbs& curve, double tolerance);

}  // namespace alignability
