// SPDX-License-Identifier: BSD-3-Clause
#include "planner/path_limits.hpp"

#include <gtest/gtest.h>

#include <random>

#include "planner/plan.hpp"
#include "tests/costmap/heading_maps.hpp"
#include "tests/planner/blind_walk.hpp"
#include "tests/planner/island.hpp"
#include "tests/planner/random_sites.hpp"

namespace alignability {
namespace {

// Poses along curves, a millimetre apart.
std::vector<Pose2> by_millimetres(std::span<const Curve> curves) {
  std::vector<Pose2> poses;
  for (const Curve& curve : curves) {
    const int steps = std::max(1, static_cast<int>(std::ceil(curve.length() / 1e-3)));
    for (int i = 0; i <= steps; ++i) poses.push_back(curve.at(curve.length() * i / steps));
  }
  return poses;
}

TEST(LimitsAlongArcs, CountAsAWalkByMillimetresDoes) {
  std::mt19937_64 engine(7);
  std::uniform_real_distribution<double> bend(-1.5, 1.5), travel(-1.0, 2.0);
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    PlanProblem problem = test::random_site(seed);
    problem.query.risk = {
        .alpha_critical = 0.2, .alpha_safe = 0.3, .unknown = seed % 2 == 0 ? UnknownPolicy::risky : UnknownPolicy::neutral};
    const RiskField risk(problem.alignability, problem.occupancy, problem.query.risk);
    Curve curve({-1.0, 4.0, 0.3});
    for (std::size_t i = 0; i < Curve::kMostArcs; ++i) curve.append(bend(engine), travel(engine));
    const std::vector<Curve> driven{curve};
    EXPECT_NEAR(longest_unrecovered(driven, risk, 0.7), test::walked_unrecovered(by_millimetres(driven), risk, 0.7), 0.01);
    EXPECT_NEAR(greatest_predicted_error(driven, risk, test::kModel), greatest_predicted_error(by_millimetres(driven), risk, test::kModel),
                1e-3);
  }
}

// What is known ends at the middle of the border cell, at x = 3.5: α is 0.9 up to there.
TEST(LimitsAlongWays, TakeWhereNobodyKnowsForBlindHoweverItIsDriven) {
  const GridGeometry row{.resolution = 1.0, .width = 8, .height = 1};
  const auto alpha = [](const Eigen::Vector2d& place, double) { return place.x() < 3.0 ? 0.9f : std::numeric_limits<float>::quiet_NaN(); };
  const OccupancyMap occupancy(Grid<float>(row, 0.0f));
  AlignabilityMap plain = test::heading_map(row, 4, alpha);
  const RiskField by_heading(plain, occupancy, {});
  plain.layers.resize(1);
  const std::vector<Pose2> walked{{0.5, 0.5, 0.0}, {0.5, 0.5, 0.0}, {7.5, 0.5, 0.0}};
  Curve straight(walked.front());
  straight.append(0.0, 7.0);
  for (const RiskField& risk : {RiskField(plain, occupancy, {}), by_heading}) {
    EXPECT_NEAR(longest_unrecovered(walked, risk, 1.0), 4.0, 1e-9);
    EXPECT_NEAR(longest_unrecovered(std::vector{straight}, risk, 1.0), 4.0, 1e-9);
    const double error = test::kModel.least + 4.0 * test::kModel.growth;
    EXPECT_NEAR(greatest_predicted_error(walked, risk, test::kModel), error, 1e-9);
    EXPECT_NEAR(greatest_predicted_error(std::vector{straight}, risk, test::kModel), error, 1e-9);
    const ErrorLimit limit{.model = test::kModel, .most = error + 1e-6};
    EXPECT_NEAR(limit.after(test::kModel.least, straight.arcs().front(), risk).value_or(-1.0), error, 1e-9);
    EXPECT_FALSE((ErrorLimit{.model = test::kModel, .most = error - 1e-3}.after(test::kModel.least, straight.arcs().front(), risk)));
  }
  EXPECT_TRUE(predicted_errors({}, by_heading, test::kModel).empty());
}

class Limits : public testing::Test {
 protected:
  void expect_kept(const PlanResult& result) const {
    ASSERT_EQ(result.status, PlanStatus::solved);
    if (result.query.max_blind_distance) {
      EXPECT_LE(*result.longest_unrecovered, *result.query.max_blind_distance + 1e-9);
      EXPECT_LE(test::walked_unrecovered(result.path, risk, result.query.recovery_distance - 0.01),
                *result.query.max_blind_distance + 0.02);
    }
    if (result.query.max_error) {
      EXPECT_LE(greatest_predicted_error(result.path, risk, test::kModel), *result.query.max_error + 1e-3);
    }
    EXPECT_GE(result.cost, *result.lower_bound);
  }

  PlanProblem problem = test::problem_with_an_island();
  RiskField risk{problem.alignability, problem.occupancy, {}};
};

// The error grows by 2 cm a blind metre from 2 cm, so either limit of the first pair, and the tighter of the others, leads over the island.
TEST_F(Limits, AreKeptTogether) {
  for (const auto& [error, blind] : {std::pair{0.3, 12.0}, {0.25, 100.0}, {5.0, 11.0}, {0.05, 12.0}}) {
    SCOPED_TRACE(error);
    problem.query.max_error = error;
    problem.query.max_blind_distance = blind;
    expect_kept(plan(problem, {}));
  }
}

TEST_F(Limits, ThatCannotBeKeptTogetherNameWhatWouldDoForEither) {
  problem.alignability.layers.front().values = Grid<float>(problem.alignability.geometry, 0.02f);
  problem.query.max_error = 10.0;
  problem.query.max_blind_distance = 5.0;
  const PlanResult result = plan(problem, {});
  EXPECT_EQ(result.status, PlanStatus::infeasible);
  EXPECT_NEAR(result.smallest_max_blind_distance.value_or(0.0), 27.0, 0.3);
  EXPECT_FALSE(result.smallest_max_error.has_value()) << "no limit of the error makes up for blind metres";
  problem.query.max_blind_distance = result.smallest_max_blind_distance;
  EXPECT_EQ(plan(problem, {}).status, PlanStatus::solved);
}

TEST_F(Limits, AreKeptByCars) {
  for (const MotionSpace space : {MotionSpace::dubins, MotionSpace::reeds_shepp}) {
    SCOPED_TRACE(to_string(space));
    problem.query.motion = {.space = space, .turn_cost = 0.2, .turning_radius = 1.0, .reverse_penalty = 1.0};
    problem.query.planner.time = 120.0;
    problem.query.max_error.reset();
    problem.query.max_blind_distance.reset();
    const PlanResult free = plan(problem, {});
    ASSERT_EQ(free.status, PlanStatus::solved);
    problem.query.max_blind_distance = 12.0;
    const PlanResult limited = plan(problem, {});
    expect_kept(limited);
    EXPECT_GT(limited.cost, free.cost);
    EXPECT_LT(limited.figures.length, 34.0) << "over the island, not all the way around";
    problem.query.max_error = 0.05;
    const PlanResult strict = plan(problem, {});
    expect_kept(strict);
    EXPECT_GT(strict.figures.length, 38.0);
    for (const PlanResult* result : {&limited, &strict}) {
      for (const Curve& curve : result->curves) {
        for (const Arc& arc : curve.arcs()) EXPECT_LE(std::abs(arc.curvature), 1.0 + 1e-9);
      }
    }
  }
}

// All the ground is blind, in a room small enough to search.
TEST_F(Limits, ThatACarCannotKeepNameOneThatItCan) {
  problem.occupancy = OccupancyMap(Grid<float>({.resolution = 0.1, .width = 60, .height = 30}, 0.0f));
  problem.alignability.geometry = {.resolution = 1.0, .width = 6, .height = 3};
  problem.alignability.layers = {{"alpha", Grid<float>(problem.alignability.geometry, 0.02f)}};
  problem.query.start = {1.0, 1.5, 0.0};
  problem.query.goal = {5.0, 1.5, 0.0};
  problem.query.motion = {.space = MotionSpace::dubins, .turn_cost = 0.2, .turning_radius = 1.0, .reverse_penalty = 1.0};
  problem.query.planner.time = 120.0;
  problem.query.max_blind_distance = 2.0;
  const PlanResult result = plan(problem, {});
  EXPECT_EQ(result.status, PlanStatus::infeasible);
  EXPECT_NEAR(result.smallest_max_blind_distance.value_or(0.0), 4.0, 0.2);
  problem.query.max_blind_distance = result.smallest_max_blind_distance;
  EXPECT_EQ(plan(problem, {}).status, PlanStatus::solved);
}

}  // namespace
}  // namespace alignability
