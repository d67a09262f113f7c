// SPDX-License-Identifier: BSD-3-Clause
#include "planner/passage_nodes.hpp"

namespace alignability {
namespace {

// [cells] along either axis that a link reaches: to what lies ahead in a passage at any angle.
constexpr int kReach = 2;
constexpr std::size_t kBetweenLooks = 256;  // places

void add_places(PassageNodes& nodes, const CostLattice& lattice, std::span<const float> costs, const PlanarMotion& motion,
                const StopTest& stop) {
  const GridGeometry& grid = lattice.geometry;
  const auto row = static_cast<std::size_t>(grid.width);
  const auto add = [&](std::size_t cell, double x, double y) {
    const Eigen::Vector2d place = grid.corner(grid.cell_of(cell)) + grid.resolution * Eigen::Vector2d(x, y);
    if (!motion.is_allowed(place, place)) return;
    nodes.places.push_back(place);
    nodes.cells.push_back(cell);
  };
  const auto is_lost = [&](std::size_t node) { return !std::isfinite(costs[node]); };
  for (std::size_t cell = row; cell + row + 1 < grid.size(); ++cell) {
    if (cell % row == 0) stop_if(stop);
    const bool open = lattice.is_open(cell);
    if (is_lost(cell) && is_lost(cell + 1) && (open || lattice.is_open(cell - row))) add(cell, 0.5, 0.0);
    if (is_lost(cell) && is_lost(cell + row) && (open || lattice.is_open(cell - 1))) add(cell, 0.0, 0.5);
    const bool across_is_lost = (is_lost(cell) && is_lost(cell + row + 1)) || (is_lost(cell + 1) && is_lost(cell + row));
    if (open && across_is_lost) add(cell, 0.5, 0.5);
  }
}

void add_links(PassageNodes& nodes, const GridGeometry& grid, std::span<const float> costs, const PlanarMotion& motion,
               const StopTest& stop) {
  const auto link = [&](std::size_t place, std::size_t other, const Eigen::Vector2d& at) {
    const Eigen::Vector2d& from = nodes.places[place];
    if (!motion.is_allowed(from, at)) return;
    const double cost = motion.cost(from, at);
    nodes.links.push_back({grid.size() + place, other, cost});
    nodes.links.push_back({other, grid.size() + place, cost});
  };
  for (std::size_t place = 0; place < nodes.places.size(); ++place) {
    if (place % kBetweenLooks == 0) stop_if(stop);
    const Cell cell = grid.cell_of(nodes.cells[place]);
    for (int y = std::max(0, cell.y - kReach); y <= std::min(grid.height - 1, cell.y + kReach + 1); ++y) {
      for (int x = std::max(0, cell.x - kReach); x <= std::min(grid.width - 1, cell.x + kReach + 1); ++x) {
        if (std::isfinite(costs[grid.index({x, y})])) link(place, grid.index({x, y}), grid.corner({x, y}));
      }
    }
    visit_places_around(nodes, grid, nodes.places[place], kReach, [&](std::size_t other) {
      if (other < place) link(place, grid.size() + other, nodes.places[other]);
    });
  }
  std::ranges::stable_sort(nodes.links, {}, &MarchingLink::from);
}

}  // namespace

PassageNodes passage_nodes(const CostLattice& lattice, std::span<const float> costs, const PlanarMotion& motion, const StopTest& stop) {
  PassageNodes nodes;
  add_places(nodes, lattice, costs, motion, stop);
  add_links(nodes, lattice.geometry, costs, motion, stop);
  return nodes;
}

}  // namespace alignability
