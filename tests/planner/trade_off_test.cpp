// SPDX-License-Identifier: BSD-3-Clause
#include "planner/trade_off.hpp"

#include <gtest/gtest.h>

#include <array>

#include "core/progress.hpp"
#include "planner/random_pairs.hpp"
#include "tests/costmap/segment_oracle.hpp"
#include "tests/planner/blind_walk.hpp"
#include "tests/planner/collision_oracle.hpp"
#include "tests/planner/two_corridors.hpp"

namespace alignability {
namespace {

class TradeOff : public testing::Test {
 protected:
  TradeOff() { problem.query.planner = {.name = "bitstar", .time = 1.0, .iterations = 4000, .seed = 3}; }

  PlanProblem problem = test::two_corridors();
};

TEST_F(TradeOff, RiskNeverRisesWithTheWeight) {
  const std::array weights{0.0, 0.1, 0.5, 0.8, 1.0, 2.0, 5.0, 20.0};
  const std::vector<PlanResult> curve = trade_off(problem.query, PlanningFields(problem), weights, {});
  ASSERT_EQ(curve.size(), weights.size());
  for (std::size_t i = 0; i < curve.size(); ++i) {
    ASSERT_EQ(curve[i].status, PlanStatus::solved);
    EXPECT_EQ(curve[i].query.weight, weights[i]);
    // The turn cost is the same under every weight, and small.
    const double other = problem.query.motion.turn_cost * curve[i].figures.turned;
    EXPECT_NEAR(curve[i].cost, curve[i].figures.length + weights[i] * curve[i].figures.risk_integral + other, 1e-9);
    if (i == 0) continue;
    EXPECT_LE(curve[i].figures.risk_integral, curve[i - 1].figures.risk_integral + 1e-9);
    const double before = curve[i - 1].cost - weights[i - 1] * curve[i - 1].figures.risk_integral;
    EXPECT_GE(curve[i].cost - weights[i] * curve[i].figures.risk_integral, before - 1e-9);
  }
  EXPECT_GT(curve.front().figures.blind_length, 9.0);
  EXPECT_LT(curve.back().figures.blind_length, 0.5);
}

TEST_F(TradeOff, RiskOfSeveralSourcesNeverRisesWithTheirCommonWeight) {
  problem.query.planner = {.name = "field"};
  problem.query.risk.alpha_weight = 0.5;
  problem.query.risk.sources = {{.name = kClearance,
                                 .weight = 0.8,
                                 .risky = 0.4,
                                 .safe = 1.2,
                                 .values = std::make_shared<const Grid<float>>(clearance_values(problem.occupancy))}};
  const std::array weights{0.0, 0.2, 1.0, 5.0};
  const std::vector<PlanResult> curve = trade_off(problem.query, PlanningFields(problem), weights, {});
  for (std::size_t i = 0; i < curve.size(); ++i) {
    ASSERT_EQ(curve[i].status, PlanStatus::solved);
    const PathFigures& figures = curve[i].figures;
    ASSERT_EQ(figures.risk_by_source.size(), 2u);
    EXPECT_NEAR(figures.risk_integral, 0.5 * figures.risk_by_source[0] + 0.8 * figures.risk_by_source[1], 1e-9);
    EXPECT_NEAR(curve[i].cost, figures.length + weights[i] * figures.risk_integral + problem.query.motion.turn_cost * figures.turned, 1e-9);
    EXPECT_LE(*curve[i].lower_bound, curve[i].cost);
    if (i == 0) continue;
    EXPECT_LE(figures.risk_integral, curve[i - 1].figures.risk_integral + 1e-9);
    EXPECT_GE(figures.length, curve[i - 1].figures.length - 1e-9);
  }
  EXPECT_GT(curve.front().figures.risk_integral, curve.back().figures.risk_integral + 1.0);
}

TEST_F(TradeOff, NoPathOfTheOthersWouldCostLess) {
  const std::array weights{0.0, 1.0, 5.0};
  const std::vector<PlanResult> curve = trade_off(problem.query, PlanningFields(problem), weights, {});
  for (const PlanResult& mine : curve) {
    for (const PlanResult& other : curve) {
      const double under_mine = other.cost + (mine.query.weight - other.query.weight) * other.figures.risk_integral;
      EXPECT_LE(mine.cost, under_mine + 1e-9);
    }
  }
}

TEST_F(TradeOff, EachLimitOfBlindMetresIsKeptByAWalkByMillimetresAndNoOtherPathThatKeepsItIsShorter) {
  problem.query.planner.name.clear();
  const std::array limits{20.0, 11.0, 6.0, 0.0};
  const PlanningFields fields(problem);
  const std::vector<PlanResult> limited = blind_trade_off(problem.query, fields, limits, {}, {});
  ASSERT_EQ(limited.size(), limits.size());
  for (std::size_t i = 0; i < limits.size(); ++i) {
    ASSERT_EQ(limited[i].status, PlanStatus::solved);
    EXPECT_EQ(limited[i].query.max_blind_distance, limits[i]);
    EXPECT_NEAR(test::walked_unrecovered(limited[i].path, *fields.risk, problem.query.recovery_distance), *limited[i].longest_unrecovered,
                0.01);
    EXPECT_LE(*limited[i].longest_unrecovered, limits[i] + 1e-9);
    if (i > 0) {
      EXPECT_GE(limited[i].cost, limited[i - 1].cost);
    }
  }
  EXPECT_GT(*limited.front().longest_unrecovered, 11.0);
  EXPECT_GT(limited.back().figures.length, 20.0);
}

TEST_F(TradeOff, RandomPairsAreDrivableConnectedAndTheSameForASeed) {
  const PlanningFields fields(problem);
  const DrivableArea area(fields.clearance, fields.risk, problem.query.robot);
  const std::vector<PosePair> pairs = random_pairs(area, 0.1, 50, 9);
  ASSERT_EQ(pairs.size(), 50u);
  double west = 20.0;
  double east = 0.0;
  for (const PosePair& pair : pairs) {
    for (const Pose2& at : {pair.start, pair.goal}) {
      EXPECT_GE(test::brute_force_distance(problem.occupancy, at.position()), problem.query.robot.radius);
      west = std::min(west, at.x);
      east = std::max(east, at.x);
    }
  }
  EXPECT_LT(west, 2.0);
  EXPECT_GT(east, 18.0);
  EXPECT_EQ(random_pairs(area, 0.1, 50, 9).back().goal, pairs.back().goal);
  EXPECT_NE(random_pairs(area, 0.1, 50, 10).back().goal, pairs.back().goal);
}

TEST_F(TradeOff, ARobotThatFitsNowhereIsToldSo) {
  problem.query.robot.radius = 6.0;
  EXPECT_THROW(compare_pairs(problem.query, PlanningFields(problem), {.count = 1, .seed = 1, .plan = {}, .progress = {}}),
               std::runtime_error);
}

TEST_F(TradeOff, PairsAreComparedInTheirOrderWithTheProgressTold) {
  problem.query.planner.iterations = 2000;
  std::size_t told = 0;
  const auto progress = [&](Progress at) {
    EXPECT_EQ(at.done, ++told);
    EXPECT_EQ(at.total, 8u);
  };
  const PlanningFields fields(problem);
  const std::vector<Comparison> pairs = compare_pairs(problem.query, fields, {.count = 8, .seed = 4, .plan = {}, .progress = progress});
  const DrivableArea area(fields.clearance, fields.risk, problem.query.robot);
  const std::vector<PosePair> poses = random_pairs(area, problem.query.goal_tolerance.position, 8, 4);
  ASSERT_EQ(pairs.size(), 8u);
  EXPECT_EQ(told, 8u);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    EXPECT_EQ(pairs[i].shortest.query.start, poses[i].start);
    EXPECT_EQ(pairs[i].risk_aware.query.goal, poses[i].goal);
    ASSERT_TRUE(solved(pairs[i]));
    EXPECT_LE(pairs[i].risk_aware.figures.risk_integral, pairs[i].shortest.figures.risk_integral + 1e-9);
  }
}

TEST_F(TradeOff, PairsStopWhenAskedTo) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW(
      compare_pairs(problem.query, PlanningFields(problem), {.count = 5, .seed = 1, .plan = {.stop = stop.get_token()}, .progress = {}}),
      Interrupted);
}

}  // namespace
}  // namespace alignability
