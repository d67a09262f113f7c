// SPDX-License-Identifier: BSD-3-Clause
#include "planner/route_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <future>
#include <numeric>

namespace alignability {

RouteBounds::Both RouteBounds::both(const DrivableArea& area, double weight, const Eigen::Vector2d& start, const Eigen::Vector2d& goal,
                                    double tolerance, const StopTest& stop) {
  const auto lattice =
      std::make_shared<const CostLattice>(*area.risk_field(), *area.clearance_map(), weight, area.inscribed_radius(), stop);
  auto from_start = std::async(std::launch::async, [&] { return CostBound(lattice, start, 0.0, stop); });
  CostBound to_goal(lattice, goal, tolerance, stop);
  return {from_start.get(), std::move(to_goal)};
}

RouteBounds::RouteBounds(const DrivableArea& area, double weight, const Eigen::Vector2d& start, const Eigen::Vector2d& goal,
                         double tolerance, const StopTest& stop)
    : RouteBounds(both(area, weight, start, goal, tolerance, stop)) {}

RouteBounds::RouteBounds(Both both) : from_start_(std::move(both.from_start)), to_goal_(std::move(both.to_goal)) {
  constexpr std::size_t kClasses = 4096;
  // Rounded down; infinite stays so.
  std::vector<float> least(from_start_.shared_lattice()->geometry.size());
  const auto is_cut_off = [](float cost) { return !std::isfinite(cost); };
  float most = 0.0f;
  for (std::size_t cell = 0; cell < least.size(); ++cell) {
    least[cell] = static_cast<float>(CostBound::least_sum(from_start_, to_goal_, cell));
    if (is_cut_off(least[cell])) continue;
    most = std::max(most, least[cell]);
    least[cell] = std::nextafter(least[cell], -1.0f);
  }
  least_ = static_cast<double>(*std::ranges::min_element(least));
  width_ = std::max(1e-6, (static_cast<double>(most) - least_) / static_cast<double>(kClasses - 1));
  ends_.resize(kClasses, 0);
  for (const float cost : least) {
    if (!is_cut_off(cost)) ++ends_[static_cast<std::size_t>(class_of(static_cast<double>(cost)))];
  }
  std::vector<std::size_t> next(kClasses);
  std::exclusive_scan(ends_.begin(), ends_.end(), next.begin(), std::size_t{0});
  std::inclusive_scan(ends_.begin(), ends_.end(), ends_.begin());
  cells_.resize(ends_.back());
  for (std::size_t cell = 0; cell < least.size(); ++cell) {
    if (is_cut_off(least[cell])) continue;
    cells_[next[static_cast<std::size_t>(class_of(static_cast<double>(least[cell])))]++] = static_cast<std::uint32_t>(cell);
  }
}

double RouteBounds::between(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const {
  const double goal_at_from = to_goal_(from);
  const double goal_at_to = to_goal_(to);
  // Of two places that both are cut off nothing is known.
  if (!std::isfinite(goal_at_from) && !std::isfinite(goal_at_to)) return 0.0;
  return std::max(std::abs(goal_at_from - goal_at_to), std::abs(from_start_(from) - from_start_(to)));
}

std::size_t RouteBounds::cells_below(double cost) const {
  if (!(cost > least_)) return 0;
  return ends_[static_cast<std::size_t>(std::min(class_of(cost), static_cast<double>(ends_.size() - 1)))];
}

Eigen::AlignedBox2d RouteBounds::cell(std::size_t rank) const {
  const GridGeometry& grid = from_start_.shared_lattice()->geometry;
  const Cell cell = grid.cell_of(cells_[rank]);
  return {grid.corner(cell), grid.corner({cell.x + 1, cell.y + 1})};
}

}  // namespace alignability
