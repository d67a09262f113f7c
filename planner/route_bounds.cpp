// SPDX-License-Identifier: BSD-3-Clause
#include "planner/route_bounds.hpp"

#include <algorithm>
#include <cmath>

namespace alignability {
namespace {

std::shared_ptr<const CostLattice> lattice_of(const DrivableArea& area, double weight) {
  return std::make_shared<const CostLattice>(*area.risk_field(), *area.clearance_map(), weight, area.inscribed_radius());
}

}  // namespace

RouteBounds::RouteBounds(const DrivableArea& area, double weight, const Eigen::Vector2d& start, const Eigen::Vector2d& goal,
                         double tolerance)
    : from_start_(lattice_of(area, weight), start, 0.0), to_goal_(from_start_.shared_lattice(), goal, tolerance) {
  const CostLattice& lattice = *from_start_.shared_lattice();
  for (std::size_t cell = 0; cell < lattice.geometry.size(); ++cell) {
    if (!lattice.is_open(cell)) continue;
    const double least = CostBound::least_sum(from_start_, to_goal_, cell);
    if (std::isfinite(least)) ranked_.push_back({std::nextafter(static_cast<float>(least), -1.0f), static_cast<std::uint32_t>(cell)});
  }
  std::ranges::sort(ranked_, {}, [](const Ranked& ranked) { return std::pair(ranked.least, ranked.cell); });
}

double RouteBounds::between(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const {
  const double goal_at_from = to_goal_(from);
  const double goal_at_to = to_goal_(to);
  // Of two places that both are cut off nothing is known.
  if (!std::isfinite(goal_at_from) && !std::isfinite(goal_at_to)) return 0.0;
  return std::max(std::abs(goal_at_from - goal_at_to), std::abs(from_start_(from) - from_start_(to)));
}

std::size_t RouteBounds::cells_below(double cost) const {
  const auto end = std::ranges::lower_bound(ranked_, cost, {}, [](const Ranked& ranked) { return static_cast<double>(ranked.least); });
  return static_cast<std::size_t>(end - ranked_.begin());
}

Eigen::AlignedBox2d RouteBounds::cell(std::size_t rank) const {
  const GridGeometry& grid = from_start_.shared_lattice()->geometry;
  const Cell cell = grid.cell_of(ranked_[rank].cell);
  return {grid.corner(cell), grid.corner({cell.x + 1, cell.y + 1})};
}

}  // namespace alignability
