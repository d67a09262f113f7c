// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "planner/planar_path.hpp"

namespace alignability::benchmark {

enum class GridSearch {
  eight_connected,  ///< A* over the centres of the map's cells
  any_angle,        ///< Theta* (Nash et al. 2007): a node's parent is any that it sees and that makes it cheaper
};

/// What a user of grid planners has for the same cost: over the centres of the map's cells where the disk fits, by the exact cost of
/// motions.
std::optional<PlanarPath> grid_path(GridSearch kind, const PlanarMotion& motion, const Eigen::Vector2d& start, const Eigen::Vector2d& goal);

}  // namespace alignability::benchmark
