// SPDX-License-Identifier: BSD-3-Clause
#include "tests/planner/plane_site.hpp"

#include <limits>
#include <numeric>
#include <queue>

namespace alignability::test {

double least_cost_by_graph(const PlanarMotion& motion, int finer, const Eigen::Vector2d& start, const Eigen::Vector2d& goal) {
  GridGeometry grid = motion.clearance->geometry();
  grid.resolution /= finer;
  grid.width = grid.width * finer + 1;
  grid.height = grid.height * finer + 1;
  std::vector<Cell> steps;
  for (int y = -4; y <= 4; ++y) {
    for (int x = -4; x <= 4; ++x) {
      if (std::gcd(x, y) == 1 && std::abs(x) + std::abs(y) <= 5) steps.push_back({x, y});
    }
  }
  const auto near = [&](Cell cell, const Eigen::Vector2d& place) { return (grid.corner(cell) - place).norm() < 3.0 * grid.resolution; };
  std::vector<double> reached(grid.size(), std::numeric_limits<double>::infinity());
  double at_goal = std::numeric_limits<double>::infinity();
  std::priority_queue<std::pair<double, std::size_t>, std::vector<std::pair<double, std::size_t>>, std::greater<>> front;
  const auto improve = [&](Cell cell, double cost) {
    if (cost >= reached[grid.index(cell)]) return;
    reached[grid.index(cell)] = cost;
    front.emplace(cost, grid.index(cell));
  };
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const Cell cell = grid.cell_of(i);
    if (near(cell, start) && motion.is_allowed(start, grid.corner(cell))) improve(cell, motion.cost(start, grid.corner(cell)));
  }
  while (!front.empty() && front.top().first < at_goal) {
    const auto [cost, index] = front.top();
    front.pop();
    if (cost > reached[index]) continue;
    const Cell cell = grid.cell_of(index);
    const Eigen::Vector2d from = grid.corner(cell);
    if (near(cell, goal) && motion.is_allowed(from, goal)) at_goal = std::min(at_goal, cost + motion.cost(from, goal));
    for (const Cell& step : steps) {
      const Cell next{cell.x + step.x, cell.y + step.y};
      if (!grid.contains(next) || !motion.is_allowed(from, grid.corner(next))) continue;
      improve(next, cost + motion.cost(from, grid.corner(next)));
    }
  }
  return at_goal;
}

}  // namespace alignability::test
