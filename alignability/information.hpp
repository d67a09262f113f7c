// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <span>

#include "alignability/merged_planes.hpp"
#include "alignability/readings.hpp"

namespace alignability::detail {

/// Of points that scatter about their planes by `stddev` [m], so many of which each that voted stands for. Strips are passed over.
PlanarInformation planar_information(std::span<const MergedPlane> planes, const Eigen::Isometry3d& T_base_scan, double stddev,
                                     int points_a_vote);

/// What is left of the matrix for the place and for yaw, each where the other is unknown; needs no inverse to exist.
PlanarInformation marginal_information(const Eigen::Matrix3d& matrix);

}  // namespace alignability::detail
