// SPDX-License-Identifier: BSD-3-Clause
#include "planner/alpha_floor.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>
#include <vector>

namespace alignability {
namespace {

constexpr std::size_t kBetweenLooks = 1024;  // cells

// The ends of [low, high] and what lines through the centres of α-cells leave between: where bilinear patches meet.
std::vector<double> cuts(double low, double high, double first_center, double resolution) {
  std::vector<double> cuts{low};
  for (double line = std::floor((low - first_center) / resolution) + 1.0; first_center + line * resolution < high; line += 1.0) {
    cuts.push_back(first_center + line * resolution);
  }
  cuts.push_back(high);
  return cuts;
}

// No point of a cell has a greater α; nullopt where none has a value.
std::optional<double> greatest_alpha(const RiskField& risk, const GridGeometry& map, Cell cell) {
  const GridGeometry& nodes = risk.alpha_layer().nodes().geometry();
  const Eigen::Vector2d center = nodes.center({0, 0}), low = map.corner(cell), high = map.corner({cell.x + 1, cell.y + 1});
  const std::vector<double> columns = cuts(low.x(), high.x(), center.x(), nodes.resolution);
  const std::vector<double> rows = cuts(low.y(), high.y(), center.y(), nodes.resolution);
  const auto alpha = [&](double x, double y) { return risk.greatest_alpha({x, y}); };
  std::optional<double> greatest;
  for (std::size_t i = 0; i + 1 < columns.size(); ++i) {
    for (std::size_t j = 0; j + 1 < rows.size(); ++j) {
      if (std::isnan(alpha(0.5 * (columns[i] + columns[i + 1]), 0.5 * (rows[j] + rows[j + 1])))) continue;
      for (const double x : {columns[i], columns[i + 1]}) {
        for (const double y : {rows[j], rows[j + 1]}) {
          // On its edge a patch may give way to another that has no value: then all that is known is that α is at most 1.
          const double here = alpha(x, y);
          greatest = std::max(greatest.value_or(0.0), std::isnan(here) ? 1.0 : here);
        }
      }
    }
  }
  return greatest;
}

}  // namespace

std::optional<double> greatest_alpha_floor(const PlanarMotion& motion, const Eigen::Vector2d& start, const Eigen::Vector2d& goal,
                                           const StopTest& stop) {
  const GridGeometry& map = motion.clearance->geometry();
  const double at_start = motion.risk->greatest_alpha(start), at_goal = motion.risk->greatest_alpha(goal);
  const auto from = map.cell_near(start), to = map.cell_near(goal);
  if (!from || !to || std::isnan(at_start) || std::isnan(at_goal)) return std::nullopt;
  const double reach = map.resolution / std::numbers::sqrt2 + 1e-6 * map.resolution;
  std::vector<bool> seen(map.size(), false);
  std::priority_queue<std::pair<double, std::size_t>> front;  // what the best way to a cell keeps
  const auto see = [&](Cell cell, double kept) {
    if (!map.contains(cell) || seen[map.index(cell)] || motion.clearance->distance_at(cell) + reach < motion.radius) return;
    seen[map.index(cell)] = true;
    if (const auto here = greatest_alpha(*motion.risk, map, cell)) front.emplace(std::min(kept, *here), map.index(cell));
  };
  see(*from, std::min(at_start, at_goal));
  for (std::size_t popped = 0; !front.empty(); ++popped) {
    if (popped % kBetweenLooks == 0) stop_if(stop);
    const auto [kept, index] = front.top();
    front.pop();
    const Cell cell = map.cell_of(index);
    if (cell == *to) return kept;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) see({cell.x + dx, cell.y + dy}, kept);
    }
  }
  return std::nullopt;
}

}  // namespace alignability
