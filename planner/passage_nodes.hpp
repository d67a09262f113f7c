// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "core/progress.hpp"
#include "planner/cost_lattice.hpp"
#include "planner/planar_path.hpp"

namespace alignability {

/// Nodes in passages so narrow that none of a lattice's nodes is in them, or none that can be reached from the next. Obstacles are made of
/// cells, so where two of them are nearest to one another, the place halfway between is a node, the middle of an edge between two nodes,
/// or the middle of a cell and of its diagonals. Of all points of an edge or a diagonal, one of its ends is farthest from a convex
/// obstacle: that its middle is clear and its ends are not takes two obstacles, and such places are few.
struct PassageNodes {
  std::vector<Eigen::Vector2d> places;  ///< numbered on from the lattice's nodes
  std::vector<std::size_t> cells;       ///< that they are in, in ascending order
  std::vector<MarchingLink> links;      ///< allowed motions between these places, and between them and the lattice's nodes nearby
};

/// `costs` as drivable_costs has them. O(cells).
PassageNodes passage_nodes(const CostLattice& lattice, std::span<const float> costs, const PlanarMotion& motion, const StopTest& stop = {});

/// Calls `visit(i)` for each place in a cell within `reach` cells of the one that has `at`, along either axis.
template <typename Visit>
void visit_places_around(const PassageNodes& nodes, const GridGeometry& grid, const Eigen::Vector2d& at, int reach, Visit visit) {
  if (nodes.places.empty()) return;
  const Eigen::Array2d middle = ((at - grid.origin) / grid.resolution).array().floor();
  const int x = static_cast<int>(middle.x()), y = static_cast<int>(middle.y());
  const int left = std::max(0, x - reach), right = std::min(grid.width - 1, x + reach);
  for (int row = std::max(0, y - reach); row <= std::min(grid.height - 1, y + reach); ++row) {
    const auto first = std::ranges::lower_bound(nodes.cells, grid.index({left, row}));
    const auto last = std::upper_bound(first, nodes.cells.end(), grid.index({right, row}));
    for (auto cell = first; cell != last; ++cell) visit(static_cast<std::size_t>(cell - nodes.cells.begin()));
  }
}

}  // namespace alignability
