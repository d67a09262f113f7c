// SPDX-License-Identifier: BSD-3-Clause
#include "planner/limited_path.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "planner/plan.hpp"
#include "tests/planner/island.hpp"

namespace alignability {
namespace {

using test::kModel;
using test::problem_with_an_island;

PlanResult plan_with(std::optional<double> max_error) {
  PlanProblem problem = problem_with_an_island();
  problem.query.max_error = max_error;
  return plan(problem, {});
}

TEST(PredictedErrors, GrowOverBlindGroundAndShrinkOverRichGround) {
  const PlanProblem problem = problem_with_an_island();
  const RiskField risk(problem.alignability, problem.occupancy, {});
  const std::vector<Pose2> straight{{1.5, 10.5, 0.0}, {28.5, 10.5, 0.0}};
  const double most = greatest_predicted_error(straight, risk, kModel);
  // From about x = 3 to x = 27 the robot is blind.
  EXPECT_GT(most, 0.02 + 0.02 * 22.0);
  EXPECT_LT(most, 0.02 + 0.02 * 26.0);
  EXPECT_LT(predicted_errors(straight, risk, kModel).back().error, most);
  EXPECT_EQ(greatest_predicted_error(std::vector<Pose2>{{1.5, 10.5, 0.0}}, risk, kModel), 0.02);
}

TEST(MaxError, LeavesAPathAloneThatKeepsIt) {
  const PlanResult free = plan_with(std::nullopt), limited = plan_with(2.0);
  EXPECT_EQ(limited.path, free.path);
  EXPECT_GT(*free.predicted_error, 0.4);
}

TEST(MaxError, LeadsOverAnIslandWhereTheRobotFindsItselfAgain) {
  const PlanResult limited = plan_with(0.30);
  ASSERT_EQ(limited.status, PlanStatus::solved);
  EXPECT_LE(*limited.predicted_error, 0.30);
  EXPECT_LT(limited.figures.length, 29.0) << "not all the way around, which is 44 m";
  EXPECT_GT(limited.figures.blind_length, 5.0);
}

TEST(MaxError, LeadsAllTheWayAroundWhereItIsStrict) {
  const PlanResult limited = plan_with(0.05);
  ASSERT_EQ(limited.status, PlanStatus::solved);
  EXPECT_LE(*limited.predicted_error, 0.05);
  EXPECT_GT(limited.figures.length, 38.0);
}

TEST(MaxError, IsToldApartFromAWallAndSaysWhatWouldDo) {
  PlanProblem problem = problem_with_an_island();
  Grid<float> alpha(problem.alignability.geometry, 0.02f);
  problem.alignability.layers = {{"alpha", alpha}};
  problem.query.max_error = 0.2;
  const PlanResult limited = plan(problem, {});
  EXPECT_EQ(limited.status, PlanStatus::infeasible);
  ASSERT_TRUE(limited.smallest_max_error.has_value());
  EXPECT_NEAR(*limited.smallest_max_error, 0.02 + 0.02 * 27.0, 0.03) << "27 m, all of them blind";
  problem.query.max_error = *limited.smallest_max_error;
  EXPECT_EQ(plan(problem, {}).status, PlanStatus::solved);
}

// Start and goal see each other across 20 m of blind ground, and both stand on rich ground.
TEST(MaxError, SaysWhatWouldDoWhereTheErrorPeaksOnTheWay) {
  PlanProblem problem = problem_with_an_island();
  Grid<float> alpha(problem.alignability.geometry, 0.02f);
  for (int x : {0, 1, 2, 3, 4, 25, 26, 27, 28, 29}) {
    for (int y = 0; y < 12; ++y) alpha[Cell{x, y}] = 0.6f;
  }
  problem.alignability.layers = {{"alpha", alpha}};
  problem.query.max_error = 0.2;
  const PlanResult limited = plan(problem, {});
  EXPECT_EQ(limited.status, PlanStatus::infeasible);
  EXPECT_GT(*limited.smallest_max_error, 0.35);
  EXPECT_LT(*limited.smallest_max_error, 0.45);
  problem.query.max_error = *limited.smallest_max_error;
  EXPECT_EQ(plan(problem, {}).status, PlanStatus::solved);
}

TEST(MaxError, NeedsAModelAndOurPlanner) {
  PlanProblem problem = problem_with_an_island();
  problem.query.max_error = 0.2;
  problem.query.planner.name = "rrtstar";
  EXPECT_THROW(plan(problem, {}), std::invalid_argument);
  problem.query.planner.name.clear();
  problem.alignability.error_model.reset();
  EXPECT_THROW(plan(problem, {}), std::invalid_argument);
}

TEST(MaxError, IsKeptAtNoMoreThanWhatALooserLimitCosts) {
  std::mt19937_64 engine(3);
  std::uniform_real_distribution<float> alpha(0.0f, 0.6f);
  for (int trial = 0; trial < 5; ++trial) {
    PlanProblem problem = problem_with_an_island();
    Grid<float> random(problem.alignability.geometry, 0.0f);
    for (std::size_t i = 0; i < random.geometry().size(); ++i) random[i] = alpha(engine) < 0.3f ? 0.02f : 0.6f;
    problem.alignability.layers = {{"alpha", random}};
    double dearer = std::numeric_limits<double>::infinity();
    for (const double most : {0.06, 0.1, 0.2, 1.0}) {
      problem.query.max_error = most;
      const PlanResult result = plan(problem, {});
      if (result.status == PlanStatus::infeasible) continue;
      ASSERT_EQ(result.status, PlanStatus::solved);
      EXPECT_LE(*result.predicted_error, most);
      EXPECT_LE(result.cost, 1.02 * dearer);
      EXPECT_GE(result.cost, *result.lower_bound);
      dearer = result.cost;
    }
  }
}

}  // namespace
}  // namespace alignability
