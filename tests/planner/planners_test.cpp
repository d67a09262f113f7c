// SPDX-License-Identifier: BSD-3-Clause
#include "planner/planners.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "planner/plan.hpp"
#include "tests/planner/two_corridors.hpp"

namespace alignability {
namespace {

struct Case {
  std::string planner;
  MotionSpace space;
};

std::string name_of(const testing::TestParamInfo<Case>& info) {
  return info.param.planner + (info.param.space == MotionSpace::r2 ? "_r2" : "_se2");
}

std::vector<Case> all_cases() {
  std::vector<Case> cases;
  for (const std::string& planner : planner_names()) {
    cases.push_back({planner, MotionSpace::r2});
    cases.push_back({planner, MotionSpace::se2});
  }
  return cases;
}

PlanProblem problem_for(const Case& param) {
  PlanProblem problem = test::two_corridors();
  problem.query.planner.name = param.planner;
  problem.query.motion.space = param.space;
  problem.query.planner.time = 2.0;
  // FMT* has no answer before its last sample, however long a sanitizer makes that take.
  if (param.planner == "fmtstar") problem.query.planner.iterations = 2000;
  return problem;
}

// Looks at every centimetre of the path, and at every obstacle cell near it, with none of the planner's code.
void expect_collision_free(const PlanProblem& problem, const std::vector<Pose2>& path) {
  const GridGeometry& grid = problem.occupancy.geometry();
  const double radius = problem.query.robot.radius;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const double length = std::hypot(path[i + 1].x - path[i].x, path[i + 1].y - path[i].y);
    const int steps = std::max(1, static_cast<int>(std::ceil(length / 0.01)));
    for (int k = 0; k <= steps; ++k) {
      const double t = static_cast<double>(k) / steps;
      const double x = path[i].x + t * (path[i + 1].x - path[i].x);
      const double y = path[i].y + t * (path[i + 1].y - path[i].y);
      const int reach = static_cast<int>(radius / grid.resolution) + 2;
      const Cell at = *grid.cell_near({x, y});
      for (int dy = -reach; dy <= reach; ++dy) {
        for (int dx = -reach; dx <= reach; ++dx) {
          const Cell cell{at.x + dx, at.y + dy};
          if (problem.occupancy.is_free(cell)) continue;
          const Eigen::Vector2d low = grid.corner(cell);
          const double gap_x = std::max({low.x() - x, 0.0, x - low.x() - grid.resolution});
          const double gap_y = std::max({low.y() - y, 0.0, y - low.y() - grid.resolution});
          ASSERT_GE(std::hypot(gap_x, gap_y), radius - 1e-6) << "at " << x << ", " << y;
        }
      }
    }
  }
}

class EveryPlanner : public testing::TestWithParam<Case> {};

TEST_P(EveryPlanner, FindsTheSafeWayWhenRiskIsWeighed) {
  const PlanResult result = plan(problem_for(GetParam()), {});
  ASSERT_EQ(result.status, PlanStatus::solved);
  EXPECT_LT(result.figures.blind_length, 0.5);
  EXPECT_GT(result.figures.length, 20.0);
}

TEST_P(EveryPlanner, FindsTheShortWayWhenItIsNot) {
  PlanProblem problem = problem_for(GetParam());
  problem.query.weight = 0.0;
  const PlanResult result = plan(problem, {});
  ASSERT_EQ(result.status, PlanStatus::solved);
  EXPECT_LT(result.figures.length, 18.0);
  EXPECT_GT(result.figures.blind_length, 9.0);
}

TEST_P(EveryPlanner, NeverCollides) {
  const PlanProblem problem = problem_for(GetParam());
  const PlanResult result = plan(problem, {});
  ASSERT_EQ(result.status, PlanStatus::solved);
  expect_collision_free(problem, result.path);
}

TEST_P(EveryPlanner, ReportsTheCostOfThePathItReturns) {
  const PlanProblem problem = problem_for(GetParam());
  const PlanResult result = plan(problem, {});
  ASSERT_EQ(result.status, PlanStatus::solved);
  const RiskField risk(problem.alignability, problem.occupancy, problem.query.risk);
  double cost = 0.0;
  for (std::size_t i = 0; i + 1 < result.path.size(); ++i) {
    const Pose2& a = result.path[i];
    const Pose2& b = result.path[i + 1];
    // A midpoint sum, step by step: none of the exact integral's code.
    constexpr int kSteps = 20000;
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    for (int k = 0; k < kSteps; ++k) {
      const double t = (k + 0.5) / kSteps;
      cost += (1.0 + problem.query.weight * risk.risk(a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), 0.0)) * length / kSteps;
    }
    if (problem.query.motion.space == MotionSpace::se2) cost += problem.query.motion.turn_cost * std::abs(normalized_angle(b.yaw - a.yaw));
  }
  EXPECT_NEAR(result.cost, cost, 1e-5 * cost);
  EXPECT_GE(result.cost, result.figures.length);
}

TEST_P(EveryPlanner, StartsAtTheStartAndEndsInTheGoal) {
  const PlanProblem problem = problem_for(GetParam());
  const PlanResult result = plan(problem, {});
  ASSERT_EQ(result.status, PlanStatus::solved);
  EXPECT_NEAR((result.path.front().position() - problem.query.start.position()).norm(), 0.0, 1e-12);
  EXPECT_LE((result.path.back().position() - problem.query.goal.position()).norm(), problem.query.goal_tolerance.position + 1e-9);
  if (problem.query.motion.space == MotionSpace::se2) {
    EXPECT_LE(std::abs(normalized_angle(result.path.back().yaw - problem.query.goal.yaw)), problem.query.goal_tolerance.heading + 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(Planners, EveryPlanner, testing::ValuesIn(all_cases()), name_of);

TEST(Planners, RepeatBySeedUnderIterations) {
  for (const char* name : {"rrtstar", "fmtstar", "bitstar"}) {
    SCOPED_TRACE(name);
    PlanProblem problem = test::two_corridors();
    problem.query.planner = {.name = name, .time = 1.0, .iterations = 1500, .seed = 7};
    const PlanResult first = plan(problem, {});
    const PlanResult second = plan(problem, {});
    ASSERT_EQ(first.status, PlanStatus::solved);
    EXPECT_EQ(first.path, second.path);
    EXPECT_EQ(first.cost, second.cost);
    problem.query.planner.seed = 8;
    EXPECT_NE(plan(problem, {}).path, first.path);
  }
}

TEST(Planners, RefuseAnUnknownNameAndListTheKnown) {
  const auto refusal = refusal_of_planner("rrtsta");
  ASSERT_TRUE(refusal.has_value());
  EXPECT_NE(refusal->find("did you mean 'rrtstar'?"), std::string::npos) << *refusal;
  for (const std::string& name : planner_names()) {
    EXPECT_FALSE(refusal_of_planner(name).has_value());
    EXPECT_NE(refusal->find(name), std::string::npos);
  }
}

}  // namespace
}  // namespace alignability
