// SPDX-License-Identifier: BSD-3-Clause
#include "tests/benchmark/grid_search.hpp"

#include <limits>
#include <queue>

namespace alignability::benchmark {

std::optional<PlanarPath> grid_path(GridSearch kind, const PlanarMotion& motion, const Eigen::Vector2d& start,
                                    const Eigen::Vector2d& goal) {
  const GridGeometry& grid = motion.clearance->geometry();
  const auto from = grid.cell_near(start);
  const auto to = grid.cell_near(goal);
  if (!from || !to) return std::nullopt;
  struct Node {
    double cost = std::numeric_limits<double>::infinity();
    std::size_t parent = 0;
    bool closed = false;
  };
  std::vector<Node> nodes(grid.size());
  std::priority_queue<std::pair<double, std::size_t>, std::vector<std::pair<double, std::size_t>>, std::greater<>> open;
  const auto place = [&](std::size_t node) { return grid.center(grid.cell_of(node)); };
  const auto offer = [&](std::size_t node, std::size_t parent) {
    const double cost = nodes[parent].cost + motion.cost(place(parent), place(node));
    if (cost >= nodes[node].cost || !motion.is_allowed(place(parent), place(node))) return;
    nodes[node] = {cost, parent, false};
    open.emplace(cost + (place(node) - goal).norm(), node);
  };
  const std::size_t first = grid.index(*from);
  const std::size_t last = grid.index(*to);
  nodes[first] = {0.0, first, false};
  open.emplace(0.0, first);
  while (!open.empty() && !nodes[last].closed) {
    const std::size_t node = open.top().second;
    open.pop();
    if (nodes[node].closed) continue;
    nodes[node].closed = true;
    const Cell at = grid.cell_of(node);
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const Cell next{at.x + dx, at.y + dy};
        if (!grid.contains(next) || nodes[grid.index(next)].closed) continue;
        if (kind == GridSearch::any_angle) offer(grid.index(next), nodes[node].parent);
        offer(grid.index(next), node);
      }
    }
  }
  if (!nodes[last].closed) return std::nullopt;
  PlanarPath path{goal};
  for (std::size_t node = last; node != first; node = nodes[node].parent) path.push_back(place(node));
  path.push_back(start);
  return PlanarPath{path.rbegin(), path.rend()};
}

}  // namespace alignability::benchmark
