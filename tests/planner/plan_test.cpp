// SPDX-License-Identifier: BSD-3-Clause
#include "planner/plan.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "planner/compare.hpp"
#include "tests/planner/two_corridors.hpp"

namespace alignability {
namespace {

PlanStatus status_of(const PlanProblem& problem) { return plan(problem, {}).status; }

// The same site with a column of cells occupied from wall to wall.
PlanProblem walled_off(int column) {
  PlanProblem problem = test::two_corridors();
  Grid<float> occupancy(problem.occupancy.geometry(), 0.0f);
  for (std::size_t i = 0; i < occupancy.values().size(); ++i) {
    const Cell cell = occupancy.geometry().cell_of(i);
    occupancy[i] = cell.x == column ? 1.0f : *problem.occupancy.occupancy(cell);
  }
  problem.occupancy = OccupancyMap(std::move(occupancy));
  return problem;
}

TEST(Plan, SaysWhereStartAndGoalAreWrong) {
  const PlanProblem good = test::two_corridors();
  PlanProblem problem = good;
  problem.query.start = {-1.0, 5.0, 0.0};
  EXPECT_EQ(status_of(problem), PlanStatus::start_outside_map);
  problem = good;
  problem.query.goal = {18.0, 10.5, 0.0};
  EXPECT_EQ(status_of(problem), PlanStatus::goal_outside_map);
  problem = good;
  problem.query.start = {10.0, 5.0, 0.0};
  EXPECT_EQ(status_of(problem), PlanStatus::start_in_collision);
  problem = good;
  problem.query.goal = {19.8, 8.5, 0.0};
  EXPECT_EQ(status_of(problem), PlanStatus::goal_in_collision);
}

TEST(Plan, ProvesThatAWallOfOneCellCannotBePassed) { EXPECT_EQ(status_of(walled_off(20 * 10 - 30)), PlanStatus::no_path); }

TEST(Plan, ProvesThatAGapNarrowerThanTheRobotCannotBePassed) {
  PlanProblem problem = test::two_corridors();
  problem.query.start = {2.0, 5.0, 0.0};
  problem.query.goal = {18.0, 5.0, 0.0};
  problem.query.robot.radius = 1.6;  // the corridors are 2.4 and 2.9 m wide
  EXPECT_EQ(status_of(problem), PlanStatus::no_path);
}

TEST(Plan, StandsStillWhenTheStartIsInTheGoal) {
  PlanProblem problem = test::two_corridors();
  problem.query.goal = problem.query.start;
  const PlanResult result = plan(problem, {});
  EXPECT_EQ(result.status, PlanStatus::solved);
  EXPECT_EQ(result.path.size(), 1u);
  EXPECT_EQ(result.cost, 0.0);
  EXPECT_EQ(result.figures.length, 0.0);
}

TEST(Plan, StopsWhenAskedTo) {
  std::stop_source stop;
  stop.request_stop();
  PlanProblem problem = test::two_corridors();
  problem.query.planner.time = 60.0;
  const PlanResult result = plan(problem, {.stop = stop.get_token()});
  EXPECT_EQ(result.status, PlanStatus::interrupted);
  EXPECT_TRUE(result.path.empty());
}

TEST(Plan, RefusesNumbersOutOfRange) {
  const double kNan = std::nan("");
  const double kInfinite = std::numeric_limits<double>::infinity();
  const auto refused = [](const std::function<void(PlanQuery&)>& change) {
    PlanProblem problem = test::two_corridors();
    change(problem.query);
    EXPECT_THROW(plan(problem, {}), std::invalid_argument);
  };
  refused([&](PlanQuery& query) { query.start.x = kNan; });
  refused([&](PlanQuery& query) { query.goal.yaw = kInfinite; });
  refused([&](PlanQuery& query) { query.weight = 1e10; });
  refused([&](PlanQuery& query) { query.weight = -1.0; });
  refused([&](PlanQuery& query) { query.motion.turn_cost = kNan; });
  refused([&](PlanQuery& query) { query.planner.time = kNan; });
  refused([&](PlanQuery& query) { query.planner.iterations = 0; });
  refused([&](PlanQuery& query) { query.recovery_distance = 0.0; });
  refused([&](PlanQuery& query) { query.max_blind_distance = kNan; });
}

TEST(Plan, NamesThePlannerItChose) {
  PlanProblem problem = test::two_corridors();
  problem.query.planner.time = 0.2;
  EXPECT_FALSE(plan(problem, {}).query.planner.name.empty());
}

TEST(Plan, KeepsOutOfUnevaluatedPlacesWhenTheyAreBlocked) {
  PlanProblem problem = test::two_corridors();
  Grid<float>& alpha = problem.alignability.layers.front().values;
  // The lower way has a stretch that nobody evaluated; risk is free, so that only the policy keeps the path out of it.
  for (int x = 7; x < 13; ++x) {
    for (int y = 0; y < 4; ++y) alpha[Cell{x, y}] = std::numeric_limits<float>::quiet_NaN();
  }
  problem.query.start = {2.0, 2.0, 0.0};
  problem.query.goal = {18.0, 2.0, 0.0};
  problem.query.weight = 0.0;
  problem.query.risk.unknown = UnknownPolicy::neutral;
  EXPECT_LT(plan(problem, {}).figures.length, 18.0);
  problem.query.risk.unknown = UnknownPolicy::blocked;
  problem.query.planner.time = 2.0;
  const PlanResult result = plan(problem, {});
  ASSERT_EQ(result.status, PlanStatus::solved);
  EXPECT_GT(result.figures.length, 20.0);
}

TEST(Compare, FindsTheBlindWayShorterAndTheSafeWayLessBlind) {
  const Comparison comparison = compare(test::two_corridors(), {});
  ASSERT_EQ(comparison.shortest.status, PlanStatus::solved);
  ASSERT_EQ(comparison.risk_aware.status, PlanStatus::solved);
  EXPECT_EQ(comparison.shortest.query.weight, 0.0);
  EXPECT_LT(comparison.shortest.figures.length, comparison.risk_aware.figures.length);
  EXPECT_LT(comparison.risk_aware.figures.blind_length, 0.1 * comparison.shortest.figures.blind_length);
}

}  // namespace
}  // namespace alignability
