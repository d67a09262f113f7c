// SPDX-License-Identifier: BSD-3-Clause
#include "planner/cost_bound.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <numbers>
#include <queue>

#include "planner/plan.hpp"
#include "planner/planar_path.hpp"
#include "tests/planner/patience.hpp"
#include "tests/planner/random_sites.hpp"

namespace alignability {
namespace {

// A site whose α is given by place, at α-cells as small as the map's.
struct Site {
  Site(const GridGeometry& geometry, const std::function<float(Eigen::Vector2d)>& alpha_at,
       const std::function<bool(Eigen::Vector2d)>& is_wall, double weight, double radius) {
    Grid<float> occupied(geometry, 0.0f);
    Grid<float> alpha(geometry, 0.0f);
    for (std::size_t i = 0; i < geometry.size(); ++i) {
      const Eigen::Vector2d at = geometry.center(geometry.cell_of(i));
      occupied[i] = is_wall(at) ? 1.0f : 0.0f;
      alpha[i] = alpha_at(at);
    }
    const OccupancyMap occupancy(std::move(occupied));
    AlignabilityMap map;
    map.geometry = geometry;
    map.layers.push_back({"alpha", std::move(alpha)});
    motion = {std::make_shared<const RiskField>(map, occupancy, RiskOptions{}), std::make_shared<const ClearanceMap>(occupancy), weight,
              radius};
  }

  CostBound bound_to(const Eigen::Vector2d& place, double tolerance) const {
    return {std::make_shared<const CostLattice>(*motion.risk, *motion.clearance, motion.weight, motion.radius), place, tolerance};
  }

  PlanarMotion motion;
};

double cost_of(const PlanarPath& path, const PlanarMotion& motion) {
  double cost = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) cost += motion.cost(path[i - 1], path[i]);
  return cost;
}

bool nowhere(const Eigen::Vector2d&) { return false; }
float safe(const Eigen::Vector2d&) { return 1.0f; }

GridGeometry square(double resolution, int cells) {
  GridGeometry geometry;
  geometry.resolution = resolution;
  geometry.width = cells;
  geometry.height = cells;
  return geometry;
}

TEST(CostBound, IsTheDistanceButForALittleWhereCostIsEven) {
  const Site site(square(0.05, 400), safe, nowhere, 5.0, 0.2);
  const Eigen::Vector2d goal(4.03, 9.01);
  const CostBound bound = site.bound_to(goal, 0.1);
  EXPECT_EQ(bound(goal), 0.0);
  for (int degrees = 0; degrees < 360; degrees += 7) {
    SCOPED_TRACE(degrees);
    const double angle = radians(degrees);
    const Eigen::Vector2d at = goal + 3.5 * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    EXPECT_LE(bound(at), 3.4);
    EXPECT_GE(bound(at), 0.93 * 3.4);
  }
}

TEST(CostBound, IsBelowARefractedRayAndNearIt) {
  // The cost is 1 left of x = 9.5 and 3 right of 10.5, linear between; by Snell's law p = c·sin(angle to x) is the same all along a ray.
  const auto alpha = [](const Eigen::Vector2d& at) { return at.x() < 10.0 ? 0.4f : 0.1f; };
  Site site(square(1.0, 20), alpha, nowhere, 2.0, 0.2);
  site.motion.clearance = std::make_shared<const ClearanceMap>(OccupancyMap(Grid<float>(square(0.05, 400), 0.0f)));
  const Eigen::Vector2d start(3.0, 4.0), goal(14.0, 16.0);
  const auto over_x = [&](const std::function<double(double)>& f) {
    constexpr int kSteps = 11000;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
      const double x = start.x() + (goal.x() - start.x()) * (i + 0.5) / kSteps;
      sum += f(1.0 + 2.0 * std::clamp(x - 9.5, 0.0, 1.0)) * (goal.x() - start.x()) / kSteps;
    }
    return sum;
  };
  double low = 0.0, high = 1.0;
  while (high - low > 1e-12) {
    const double p = 0.5 * (low + high);
    (over_x([p](double c) { return p / std::sqrt(c * c - p * p); }) < goal.y() - start.y() ? low : high) = p;
  }
  const double least = over_x([p = low](double c) { return c * c / std::sqrt(c * c - p * p); });
  const double bound = site.bound_to(goal, 0.0)(start);
  EXPECT_LE(bound, least);
  EXPECT_GE(bound, 0.95 * least);
  const auto path = steepest_path(site.motion, start, goal);
  ASSERT_TRUE(path.has_value());
  const double cost = cost_of(refined(*path, site.motion), site.motion);
  EXPECT_GE(cost, least * (1.0 - 1e-6));
  EXPECT_LE(cost, least * 1.001);
}

TEST(CostBound, IsBelowTheStringAroundACornerAndThePathIsTheString) {
  // A block with its upper corners at (9, 10) and (10, 10), from which the robot's centre keeps 0.5 m. On either side the string is a
  // tangent from 4 m beside and 5 m below the corner, then an arc up to the level part.
  const auto wall = [](const Eigen::Vector2d& at) { return at.x() > 9.0 && at.x() < 10.0 && at.y() < 10.0; };
  const Site site(square(0.05, 400), safe, wall, 5.0, 0.5);
  const Eigen::Vector2d start(5.0, 5.0), goal(14.0, 5.0);
  const double to_corner = std::hypot(4.0, 5.0);
  const double arc = std::atan2(5.0, 4.0) + std::asin(0.5 / to_corner);
  const double string = 2.0 * (std::sqrt(to_corner * to_corner - 0.25) + 0.5 * arc) + 1.0;
  const double bound = site.bound_to(goal, 0.0)(start);
  EXPECT_LE(bound, string);
  EXPECT_GE(bound, 0.97 * string);
  const auto path = steepest_path(site.motion, start, goal);
  ASSERT_TRUE(path.has_value());
  const double length = cost_of(refined(*path, site.motion), site.motion);
  EXPECT_GE(length, string - 1e-9);
  EXPECT_LE(length, 1.003 * string);
}

TEST(CostBound, NeverChangesByMoreThanAMotionCosts) {
  std::mt19937_64 engine(21);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  int motions = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    const PlanProblem problem = test::random_site(seed);
    const PlanningFields fields(problem);
    const PlanarMotion motion{fields.risk, fields.clearance, problem.query.weight, problem.query.robot.radius};
    const auto lattice = std::make_shared<const CostLattice>(*fields.risk, *fields.clearance, motion.weight, motion.radius);
    const CostBound bound(lattice, problem.query.goal.position(), 0.1);
    const GridGeometry& map = problem.occupancy.geometry();
    for (int i = 0; i < 2000; ++i) {
      const Eigen::Vector2d a = map.origin + map.extent().cwiseProduct(Eigen::Vector2d(uniform(engine), uniform(engine)));
      const double reach = std::pow(10.0, -3.0 * uniform(engine));
      const Eigen::Vector2d b = a + reach * Eigen::Vector2d(uniform(engine) - 0.5, uniform(engine) - 0.5);
      if (!motion.is_allowed(a, b) || !std::isfinite(bound(a))) continue;
      ++motions;
      const double cost = motion.cost(a, b);
      ASSERT_LE(std::abs(bound(a) - bound(b)), cost * (1.0 + 1e-9) + 1e-12) << a.transpose() << " to " << b.transpose();
    }
  }
  EXPECT_GT(motions, 20000);
}

// The least cost over the corners of cells of a grid `finer` times as fine as the map, by motions to 32 neighbours.
double graph_cost(const PlanarMotion& motion, int finer, const Eigen::Vector2d& start, const Eigen::Vector2d& goal) {
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
  EXPECT_GE(steps.size(), 32u);
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

TEST(CostBound, StaysBelowAGraphSearchThatClosesIn) {
  int searched = 0;
  for (std::uint64_t seed = 100; seed < 100 + 25 / test::kOneOf; ++seed) {
    SCOPED_TRACE(seed);
    const PlanProblem problem = test::random_site(seed);
    const PlanningFields fields(problem);
    const PlanarMotion motion{fields.risk, fields.clearance, problem.query.weight, problem.query.robot.radius};
    const Eigen::Vector2d start = problem.query.start.position(), goal = problem.query.goal.position();
    const auto lattice = std::make_shared<const CostLattice>(*fields.risk, *fields.clearance, motion.weight, motion.radius);
    const double bound = CostBound(lattice, goal, 0.0)(start);
    const double coarse = graph_cost(motion, 1, start, goal);
    const double fine = graph_cost(motion, 3, start, goal);
    EXPECT_LE(bound, fine);
    EXPECT_LE(bound, coarse);
    if (!std::isfinite(fine) || (start - goal).norm() < 1.0) continue;
    ++searched;
    EXPECT_LE(fine, coarse * 1.01);
    const auto path = steepest_path(motion, start, goal);
    if (!path) continue;
    const double cost = cost_of(refined(*path, motion), motion);
    EXPECT_GE(cost, bound);
    EXPECT_LE(cost, 1.02 * fine);
  }
  EXPECT_GT(searched, 10 / test::kOneOf);
}

TEST(CostBound, IsInfiniteWhereAWallProvesThatNoPathLeads) {
  const auto wall = [](const Eigen::Vector2d& at) { return std::abs(at.x() - 5.0) < 0.06; };
  const Site site(square(0.1, 100), safe, wall, 5.0, 0.2);
  const CostBound bound = site.bound_to({2.0, 5.0}, 0.1);
  EXPECT_EQ(bound({8.0, 5.0}), std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isfinite(bound({4.0, 9.0})));
  EXPECT_EQ(bound({5.0, 5.0}), std::numeric_limits<double>::infinity());
  EXPECT_EQ(bound({-1.0, 5.0}), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace alignability
