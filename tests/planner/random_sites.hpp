// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <random>

#include "costmap/clearance_map.hpp"
#include "planner/plan_problem.hpp"

namespace alignability::test {

/// α-cells of 1 m over a site, the value of each drawn in turn.
template <typename Draw>
AlignabilityMap alignability_by_metre(const GridGeometry& site, Draw draw) {
  Grid<float> alpha({.resolution = 1.0,
                     .origin = site.origin,
                     .width = static_cast<int>(std::ceil(site.extent().x())),
                     .height = static_cast<int>(std::ceil(site.extent().y()))},
                    0.0f);
  for (std::size_t i = 0; i < alpha.values().size(); ++i) alpha[i] = draw();
  AlignabilityMap map;
  map.geometry = alpha.geometry();
  map.layers.push_back({"alpha", std::move(alpha)});
  return map;
}

inline AlignabilityMap random_alignability(const GridGeometry& site, std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
  return alignability_by_metre(site, [&] { return uniform(engine); });
}

/// A small site made of blocks and random alignability, some of it without a value, its α-cells' centres on no line of the map; start and
/// goal are clear of obstacles, which does not mean that a path joins them. The same seed makes the same site.
inline PlanProblem random_site(std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  const auto share = [&] { return static_cast<double>(engine() >> 11) * 0x1p-53; };
  const double resolution = 0.07 + 0.1 * share();
  Grid<float> occupancy({.resolution = resolution, .origin = {-3.0 + share(), 2.0 + share()}, .width = 60, .height = 45}, 0.0f);
  for (int block = 0; block < 6; ++block) {
    const int x0 = static_cast<int>(55 * share()), y0 = static_cast<int>(40 * share());
    const int width = 2 + static_cast<int>(12 * share()), height = 2 + static_cast<int>(12 * share());
    for (int y = y0; y < std::min(45, y0 + height); ++y) {
      for (int x = x0; x < std::min(60, x0 + width); ++x) occupancy[Cell{x, y}] = 1.0f;
    }
  }
  const GridGeometry site = occupancy.geometry();
  PlanProblem problem{OccupancyMap(std::move(occupancy)), {}, {}};
  problem.alignability = alignability_by_metre(
      site, [&] { return share() < 0.1 ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(0.6 * share()); });
  problem.query.robot.radius = 0.1 + 0.3 * share();
  problem.query.weight = 8.0 * share();
  const ClearanceMap clearance(problem.occupancy);
  const auto place = [&]() -> Pose2 {
    for (;;) {
      const Eigen::Vector2d at = site.origin + site.extent().cwiseProduct(Eigen::Vector2d(share(), share()));
      if (clearance.is_clear(at, problem.query.robot.radius)) return {at.x(), at.y(), 6.0 * share() - 3.0};
    }
  };
  problem.query.start = place();
  problem.query.goal = place();
  return problem;
}

/// The same with risk from clearance and from a raster too, part of it without a value and its cells' centres on no line of another.
inline PlanProblem random_site_of_many_risks(std::uint64_t seed) {
  PlanProblem problem = random_site(seed);
  std::mt19937_64 engine(seed + 1000);
  const auto share = [&] { return static_cast<double>(engine() >> 11) * 0x1p-53; };
  const GridGeometry& site = problem.occupancy.geometry();
  GridGeometry cells{.resolution = 0.25 + 0.5 * share(), .origin = site.origin - Eigen::Vector2d(0.2 * share(), 0.2 * share())};
  const Eigen::Array2d size = (site.upper_corner() - cells.origin).array() / cells.resolution;
  cells.width = static_cast<int>(std::ceil(size.x()));
  cells.height = static_cast<int>(std::ceil(size.y()));
  Grid<float> traffic(cells, 0.0f);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    traffic[i] = share() < 0.05 ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(share());
  }
  RiskOptions& risk = problem.query.risk;
  risk.alpha_weight = share();
  risk.sources.push_back({.name = "traffic",
                          .weight = share(),
                          .risky = 0.9,
                          .safe = 0.4,
                          .unknown = UnknownPolicy::neutral,
                          .values = std::make_shared<const Grid<float>>(std::move(traffic))});
  risk.sources.push_back({.name = kClearance,
                          .weight = share(),
                          .risky = 0.2,
                          .safe = 0.4 + share(),
                          .values = std::make_shared<const Grid<float>>(clearance_values(problem.occupancy))});
  return problem;
}

}  // namespace alignability::test
