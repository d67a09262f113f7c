// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "costmap/alignability_map.hpp"

namespace alignability {

/// The cells that a polygon meets, by its corners in order, either way round [m]. Throws std::invalid_argument for fewer than three
/// corners or one that is not finite. O(cells in its bounding box · corners).
std::vector<Cell> cells_meeting(const GridGeometry& geometry, std::span<const Eigen::Vector2d> polygon);

/// `before` with some cells, NaN or not, as `rebuilt` has them, and what `rebuilt` says of how it was made. Throws std::invalid_argument
/// that completes "the map …" where the two were not made alike: on another grid, with another sensor, seed or options.
AlignabilityMap updated(const AlignabilityMap& before, AlignabilityMap rebuilt, std::span<const Cell> cells);

}  // namespace alignability
