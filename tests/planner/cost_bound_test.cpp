// SPDX-License-Identifier: BSD-3-Clause
#include "planner/cost_bound.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "planner/goal_field.hpp"
#include "planner/plan.hpp"
#include "tests/planner/patience.hpp"
#include "tests/planner/plane_site.hpp"
#include "tests/planner/random_sites.hpp"

namespace alignability {
namespace {

using namespace test;

CostBound bound_to(const Eigen::Vector2d& place, double tolerance, const PlanarMotion& motion) {
  return {std::make_shared<const CostLattice>(*motion.risk, *motion.clearance, motion.weight, motion.radius), place, tolerance};
}

TEST(CostBound, IsTheDistanceButForALittleWhereCostIsEven) {
  const PlaneSite site(square(0.05, 400), safe, nowhere, 5.0, 0.2);
  const Eigen::Vector2d goal(4.03, 9.01);
  const CostBound bound = bound_to(goal, 0.1, site.motion);
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
  PlaneSite site(square(1.0, 20), alpha, nowhere, 2.0, 0.2);
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
  const double bound = bound_to(goal, 0.0, site.motion)(start);
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
  const PlaneSite site(square(0.05, 400), safe, wall, 5.0, 0.5);
  const Eigen::Vector2d start(5.0, 5.0), goal(14.0, 5.0);
  const double to_corner = std::hypot(4.0, 5.0);
  const double arc = std::atan2(5.0, 4.0) + std::asin(0.5 / to_corner);
  const double string = 2.0 * (std::sqrt(to_corner * to_corner - 0.25) + 0.5 * arc) + 1.0;
  const double bound = bound_to(goal, 0.0, site.motion)(start);
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
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(seed);
    const PlanProblem problem = seed <= 60 ? random_site(seed) : random_site_of_many_risks(seed);
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
  EXPECT_GT(motions, 33000);
}

TEST(CostBound, StaysBelowAGraphSearchThatClosesIn) {
  int searched = 0;
  for (std::uint64_t seed = 100; seed < 100 + 40 / kOneOf; ++seed) {
    SCOPED_TRACE(seed);
    const PlanProblem problem = seed % 8 < 5 ? random_site(seed) : random_site_of_many_risks(seed);
    const PlanningFields fields(problem);
    const PlanarMotion motion{fields.risk, fields.clearance, problem.query.weight, problem.query.robot.radius};
    const Eigen::Vector2d start = problem.query.start.position(), goal = problem.query.goal.position();
    const auto lattice = std::make_shared<const CostLattice>(*fields.risk, *fields.clearance, motion.weight, motion.radius);
    const double bound = CostBound(lattice, goal, 0.0)(start);
    const double coarse = least_cost_by_graph(motion, 1, start, goal);
    const double fine = least_cost_by_graph(motion, 3, start, goal);
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
  EXPECT_GT(searched, 16 / kOneOf);
}

TEST(CostBound, IsInfiniteWhereAWallProvesThatNoPathLeads) {
  const auto wall = [](const Eigen::Vector2d& at) { return std::abs(at.x() - 5.0) < 0.06; };
  const PlaneSite site(square(0.1, 100), safe, wall, 5.0, 0.2);
  const CostBound bound = bound_to({2.0, 5.0}, 0.1, site.motion);
  EXPECT_EQ(bound({8.0, 5.0}), std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isfinite(bound({4.0, 9.0})));
  EXPECT_EQ(bound({5.0, 5.0}), std::numeric_limits<double>::infinity());
  EXPECT_EQ(bound({-1.0, 5.0}), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace alignability
