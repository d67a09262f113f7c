// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <span>

namespace alignability {

/// Where a site lies whose floor is `z = 0` of `map`, by the points scanned of it in a frame whose z points up to within 20 degrees. The
/// floor is the lowest of the large planes near level, large being a quarter of the largest (RANSAC, by PCL); the point of it beneath the
/// frame's origin becomes `map`'s origin, and x stays above x. The same for the same points. Throws std::invalid_argument where there is no
/// such plane.
Eigen::Isometry3d leveled(std::span<const Eigen::Vector3f> points);

}  // namespace alignability
