// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "alignability/alignability.hpp"
#include "costmap/risk_field.hpp"

namespace alignability {

/// What a plane is by its normal: a floor's points up to within 30°, a ceiling's down, a wall's sideways; a slope is what is left. The top
/// of a pallet counts as floor.
enum class PlaneKind { floor, ceiling, wall, slope };

/// What a scan saw of one plane: segments that lie in it to within 30° and 5 cm, apart from one another for whatever reason.
struct ExplainedPlane {
  PlaneKind kind = PlaneKind::slope;
  /// The plane's own, from which noise makes the normals of its points lean: unit, axes of `map`, towards the sensor. It is the narrowest
  /// axis of the points; where they are no wider than noise, a strip, the principal axis of their normals.
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  int segments = 0;
  std::size_t points = 0;                             ///< those with a normal
  double share = 0.0;                                 ///< of the normals of all planes
  double distance = 0.0;                              ///< from a lidar that saw it to the plane, which goes on beyond its points [m]
  Eigen::Vector3d extents = Eigen::Vector3d::Zero();  ///< of its oriented bounding box, the longest first [m]
  /// Its part of λ_c: Σ (n·w)² over its points' normals n, w the weakest direction, as a share of that sum over all planes.
  double holds = 0.0;
};

/// Why a scan scores what it does.
struct Explanation {
  Alignability alignability;                       ///< as `score` has it, the weakest direction in the frame of the scan
  Eigen::Matrix3d axes = Eigen::Matrix3d::Zero();  ///< of the eigenvalues in `map`, by column; the largest part of each is positive
  std::vector<ExplainedPlane> planes;              ///< the largest first
  std::vector<int> plane_of_point;                 ///< for each point of the scan its place in `planes`; -1 = none
  /// The part of λ_c that would be gone if all points of a plane had its own normal, in [0,1]. High on bare floors: docs/design.md.
  double noise = 0.0;

  Eigen::Vector3d weakest_axis() const { return axes.col(alignability.dimensions - 1); }
};

/// Scores a scan and tells what came of which plane. `R_map_scan` turns the axes of the scan to those of `map`, `range_stddev` is the
/// lidar's noise [m], >= 0. Without planes all but `alignability.points` and `plane_of_point` is empty or 0.
Explanation explain(const Scan& scan, const Eigen::Matrix3d& R_map_scan, double range_stddev, const AlignabilityOptions& options);

/// What α is worth to a planner: blind below alpha_critical, safe from alpha_safe on.
enum class Verdict { blind, poor, safe };
Verdict verdict(double alpha, const RiskOptions& risk);

std::string_view to_string(PlaneKind kind);
std::string_view to_string(Verdict verdict);

/// "up" or "down" to within 30° of it, else the heading in degrees, (-180, 180]: "-90 deg", "45 deg, 40 deg up".
std::string direction_text(const Eigen::Vector3d& unit);

/// Where the scan is held least: "along x", "along heading 61 deg", or where the second eigenvalue is at most 1.2 times the third, "in any
/// horizontal direction", "in any direction square to y"; "in every direction alike" where the first is too; "" without planes.
std::string weakest_text(const Explanation& explanation);

/// Verdict and reason in a few sentences: "Blind, alpha 0.020: nothing faces along x: the normals are of walls …" A plane faces a direction
/// when its normal is less than 45° from it.
std::string sentence(const Explanation& explanation, const RiskOptions& risk);

}  // namespace alignability
