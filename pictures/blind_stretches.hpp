// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "pictures/path_picture.hpp"

namespace alignability::detail {

/// A stretch of a path by arc length [m].
struct Stretch {
  double from = 0.0;
  double to = 0.0;
};

/// Where a profile is blind, α taken to be linear between its points; an end between known and unknown lies halfway. Apart and in order.
std::vector<Stretch> blind_stretches(std::span<const ProfilePoint> profile, const RiskOptions& risk);

/// The corners of that part of a polyline, `from` and `to` as shares of its length. Empty for a polyline of no length.
std::vector<Eigen::Vector2d> part_of(std::span<const Pose2> poses, double from, double to);

}  // namespace alignability::detail
