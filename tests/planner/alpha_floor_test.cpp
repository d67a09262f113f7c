// SPDX-License-Identifier: BSD-3-Clause
#include "planner/alpha_floor.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "planner/plan.hpp"
#include "tests/planner/island.hpp"
#include "tests/planner/two_corridors.hpp"

namespace alignability {
namespace {

// The safe corridor has 0.8, the blind one 0.02.
class MinAlignability : public testing::TestWithParam<const char*> {};

TEST_P(MinAlignability, ShutsThePlacesBelowIt) {
  PlanProblem problem = test::two_corridors();
  problem.query.weight = 0.0;
  problem.query.planner.name = GetParam();
  const PlanResult free = plan(problem, {});
  ASSERT_EQ(free.status, PlanStatus::solved);
  EXPECT_LT(free.figures.alpha_min, 0.1);
  problem.query.risk.min_alpha = 0.3;
  const PlanResult limited = plan(problem, {});
  ASSERT_EQ(limited.status, PlanStatus::solved);
  EXPECT_GE(limited.figures.alpha_min, 0.3 - 1e-9);
  EXPECT_GT(limited.figures.length, 20.0);
}

INSTANTIATE_TEST_SUITE_P(Planner, MinAlignability, testing::Values("field", "bitstar", "rrtstar", "prmstar"),
                         [](const auto& instance) { return std::string(instance.param); });

TEST(AlphaFloor, IsInfeasibleWhereNoWayKeepsItAndSaysWhichWould) {
  PlanProblem problem = test::two_corridors();
  problem.query.risk.min_alpha = 0.9;
  const PlanResult limited = plan(problem, {});
  EXPECT_EQ(limited.status, PlanStatus::infeasible);
  ASSERT_TRUE(limited.greatest_min_alpha.has_value());
  EXPECT_NEAR(*limited.greatest_min_alpha, 0.8, 0.002);
  problem.query.risk.min_alpha = *limited.greatest_min_alpha;
  EXPECT_EQ(plan(problem, {}).status, PlanStatus::solved);
}

TEST(AlphaFloor, IsInfeasibleFromAPlaceBelowItAndNotACollision) {
  PlanProblem problem = test::problem_with_an_island();
  problem.query.start = {9.5, 9.5, 0.0};
  problem.query.risk.min_alpha = 0.2;
  const PlanResult limited = plan(problem, {});
  EXPECT_EQ(limited.status, PlanStatus::infeasible);
  EXPECT_NEAR(*limited.greatest_min_alpha, 0.02, 0.002);
}

TEST(AlphaFloor, IsToldApartFromAWall) {
  PlanProblem problem = test::two_corridors();
  problem.query.risk.min_alpha = 0.9;
  problem.query.goal = {-5.0, 5.0, 0.0};
  EXPECT_EQ(plan(problem, {}).status, PlanStatus::goal_outside_map);
  problem.query.goal = {10.0, 5.0, 0.0};
  EXPECT_EQ(plan(problem, {}).status, PlanStatus::goal_in_collision);
}

// A wall at x = 2.5 to 3.5 with a gap of half a metre, in which no corner of a cell is as far from either side as the robot is wide.
PlanProblem problem_with_a_gap(float alpha) {
  Grid<float> occupancy({.resolution = 0.1, .width = 60, .height = 40}, 0.0f);
  for (int x = 25; x < 35; ++x) {
    for (int y = 0; y < 40; ++y) occupancy[Cell{x, y}] = y >= 18 && y < 23 ? 0.0f : 1.0f;
  }
  PlanProblem problem{OccupancyMap(std::move(occupancy)), {}, {}};
  problem.alignability.geometry = {.resolution = 1.0, .width = 6, .height = 4};
  problem.alignability.layers = {{"alpha", Grid<float>(problem.alignability.geometry, alpha)}};
  problem.query.robot.radius = 0.24;
  problem.query.start = {1.0, 1.0, 0.0};
  problem.query.goal = {5.0, 3.0, 0.0};
  return problem;
}

TEST(AlphaFloor, ShutsNoGapThatHoldsNoCorner) {
  PlanProblem problem = problem_with_a_gap(0.9f);
  problem.query.risk.min_alpha = 0.5;
  EXPECT_EQ(plan(problem, {}).status, PlanStatus::solved);
}

TEST(AlphaFloor, IsKeptToTheLastDigit) {
  PlanProblem problem = problem_with_a_gap(0.3009f);
  problem.query.risk.min_alpha = 0.3005;
  EXPECT_EQ(plan(problem, {}).status, PlanStatus::solved);
  problem.query.risk.min_alpha = 0.3010;
  const PlanResult limited = plan(problem, {});
  EXPECT_EQ(limited.status, PlanStatus::infeasible);
  EXPECT_EQ(limited.greatest_min_alpha, 0.3);
}

TEST(AlphaFloor, ShutsPlacesWithoutAValueEvenAtZero) {
  PlanProblem problem = problem_with_a_gap(std::numeric_limits<float>::quiet_NaN());
  problem.query.risk.min_alpha = 0.0;
  const PlanResult limited = plan(problem, {});
  EXPECT_EQ(limited.status, PlanStatus::infeasible);
  EXPECT_FALSE(limited.greatest_min_alpha.has_value());
}

TEST(GreatestAlphaFloor, IsTheLeastOnTheBestOfTwoWays) {
  const PlanProblem problem = test::problem_with_an_island();
  const PlanningFields fields(problem);
  const PlanarMotion motion{fields.risk, fields.clearance, 0.0, 0.3};
  EXPECT_NEAR(*greatest_alpha_floor(motion, {1.5, 10.5}, {28.5, 10.5}), 0.6, 0.002) << "along the bottom";
  EXPECT_NEAR(*greatest_alpha_floor(motion, {1.5, 10.5}, {15.0, 7.5}), 0.02, 0.002) << "to the island";
  EXPECT_FALSE(greatest_alpha_floor({fields.risk, fields.clearance, 0.0, 50.0}, {1.5, 10.5}, {28.5, 10.5}).has_value());
}

}  // namespace
}  // namespace alignability
