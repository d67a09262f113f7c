// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace alignability {

/// One point for each cube of a side [m] that holds some: their mean. Cubes are stacked from the origin. Points that are not finite are
/// dropped; those beyond a million sides from the origin are kept as they are, at the end. Ordered by cube, whatever the order of the
/// points. O(n log n). Throws std::invalid_argument for a side that is not greater than 0.
std::vector<Eigen::Vector3f> thinned(std::span<const Eigen::Vector3f> points, double side);

}  // namespace alignability
