// SPDX-License-Identifier: BSD-3-Clause
#include "planner/planners.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "core/file.hpp"
#include "planner/plan.hpp"
#include "planner/refused_planners.hpp"
#include "tests/planner/collision_oracle.hpp"
#include "tests/planner/patience.hpp"
#include "tests/planner/two_corridors.hpp"

namespace alignability {
namespace {

const Robot kTruck{.radius = 0.0, .footprint = {{0.9, 0.35}, {-0.3, 0.35}, {-0.3, -0.35}, {0.9, -0.35}}};

struct Case {
  std::string planner;
  MotionSpace space;
  Robot robot;
};

std::string name_of(const testing::TestParamInfo<Case>& info) {
  return info.param.planner + '_' + to_string(info.param.space) + (info.param.robot.footprint.empty() ? "" : "_truck");
}

std::vector<Case> all_cases() {
  std::vector<Case> cases;
  for (const std::string& planner : planner_names()) {
    cases.push_back({planner, MotionSpace::r2, {.radius = 0.4, .footprint = {}}});
    cases.push_back({planner, MotionSpace::se2, {.radius = 0.4, .footprint = {}}});
    cases.push_back({planner, MotionSpace::se2, kTruck});
    for (const MotionSpace space : {MotionSpace::dubins, MotionSpace::reeds_shepp}) {
      if (refusal_of_planner(planner, space)) continue;
      cases.push_back({planner, space, {.radius = 0.4, .footprint = {}}});
      if (planner == kDefaultPlanner || planner == "rrtstar") cases.push_back({planner, space, kTruck});
    }
  }
  return cases;
}

class EveryPlanner : public testing::TestWithParam<Case> {
 protected:
  PlanProblem problem_with_weight(double weight) const {
    PlanProblem problem = test::two_corridors();
    problem.query.robot = GetParam().robot;
    problem.query.planner.name = GetParam().planner;
    problem.query.motion.space = GetParam().space;
    problem.query.motion.turning_radius = 1.0;
    problem.query.weight = weight;
    problem.query.planner.time = (weight > 0.0 ? 0.6 : 0.3) * test::kPatience;
    // Curves take longer to find, and few of a car's random motions lead where it can go on.
    if (is_curved(GetParam().space)) problem.query.planner.time *= 3.0;
    // These have no answer before their last sample, however long a sanitizer makes that take.
    if (counts_its_own_iterations(GetParam().planner)) problem.query.planner.iterations = 2000;
    return problem;
  }
};

// What is driven: of curves so many poses that the chords are within a micrometre of them, which the oracle forgives.
std::vector<Pose2> driven(const PlanResult& result) { return result.curves.empty() ? result.path : poses_along(result.curves, 2e-7); }

void expect_collision_free(const PlanProblem& problem, const PlanResult& result) {
  const auto hit = test::first_collision(problem.occupancy, problem.query.robot, driven(result));
  EXPECT_FALSE(hit.has_value()) << "at " << hit->x << ", " << hit->y << ", " << hit->yaw;
}

// A midpoint sum, step by step: none of the exact integrals' code.
constexpr int kSteps = 20000;

double cost_of_straight_path(const PlanQuery& query, const std::vector<Pose2>& path, const RiskField& risk) {
  double cost = 0.0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const Pose2& a = path[i];
    const Pose2& b = path[i + 1];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    for (int k = 0; k < kSteps; ++k) {
      const double t = (k + 0.5) / kSteps;
      cost += (1.0 + query.weight * risk.risk(a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), 0.0)) * length / kSteps;
    }
    if (query.motion.space == MotionSpace::se2) cost += query.motion.turn_cost * std::abs(normalized_angle(b.yaw - a.yaw));
  }
  return cost;
}

double cost_of_curves(const PlanQuery& query, const std::vector<Curve>& curves, const RiskField& risk) {
  double cost = 0.0;
  for (const Curve& curve : curves) {
    for (const Arc& arc : curve.arcs()) {
      for (int k = 0; k < kSteps; ++k) {
        const Pose2 at = arc.at(arc.length() * (k + 0.5) / kSteps);
        cost += (1.0 + query.weight * risk.risk(at.x, at.y, 0.0)) * arc.length() / kSteps;
      }
      cost += query.motion.turn_cost * std::abs(arc.turn()) + query.motion.reverse_penalty * std::max(0.0, -arc.travel);
    }
  }
  return cost;
}

void expect_the_cost_of_its_path(const PlanProblem& problem, const PlanResult& result) {
  const RiskField risk(problem.alignability, problem.occupancy, problem.query.risk);
  const double cost = is_curved(problem.query.motion.space) ? cost_of_curves(problem.query, result.curves, risk)
                                                            : cost_of_straight_path(problem.query, result.path, risk);
  EXPECT_NEAR(result.cost, cost, 1e-5 * cost);
  EXPECT_GE(result.cost, result.figures.length);
  ASSERT_TRUE(result.lower_bound.has_value());
  EXPECT_GE(result.cost, *result.lower_bound);
  // The bound knows nothing of turning radii.
  const double gap = is_curved(problem.query.motion.space) ? 2.0 : 1.6;
  EXPECT_LE(result.cost, gap * *result.lower_bound) << "the bound is of no use, or the path";
}

// Arcs of the turning radius and straights, each from where the last ends, forward where there is no way back; the poses along them.
void expect_drivable_by_a_car(const PlanProblem& problem, const PlanResult& result) {
  const Motion& motion = problem.query.motion;
  ASSERT_EQ(result.curves.empty(), !is_curved(motion.space));
  Pose2 at = problem.query.start;
  for (const Curve& curve : result.curves) {
    for (const Arc& arc : curve.arcs()) {
      EXPECT_LT((arc.start.position() - at.position()).norm(), 3e-6);
      EXPECT_LT(std::abs(normalized_angle(arc.start.yaw - at.yaw)), 3e-6);
      EXPECT_TRUE(arc.curvature == 0.0 || std::abs(std::abs(arc.curvature) * motion.turning_radius - 1.0) < 1e-9);
      EXPECT_TRUE(arc.travel > 0.0 || motion.space == MotionSpace::reeds_shepp);
      at = arc.end();
    }
  }
  if (result.curves.empty()) return;
  EXPECT_LT((result.path.back().position() - at.position()).norm(), 1e-9);
  double along = 0.0;
  for (std::size_t i = 1; i < result.path.size(); ++i) along += (result.path[i].position() - result.path[i - 1].position()).norm();
  EXPECT_LE(along, result.figures.length + 1e-9);
  EXPECT_GE(along, 0.999 * result.figures.length);
  EXPECT_GE(result.figures.length, (problem.query.goal.position() - problem.query.start.position()).norm() - 0.3);
}

void expect_from_start_to_goal(const PlanProblem& problem, const PlanResult& result) {
  const PlanQuery& query = problem.query;
  EXPECT_NEAR((result.path.front().position() - query.start.position()).norm(), 0.0, 1e-12);
  EXPECT_LE((result.path.back().position() - query.goal.position()).norm(), query.goal_tolerance.position + 1e-9);
  if (query.motion.space != MotionSpace::r2) {
    EXPECT_EQ(normalized_angle(result.path.front().yaw - query.start.yaw), 0.0);
    EXPECT_LE(std::abs(normalized_angle(result.path.back().yaw - query.goal.yaw)), query.goal_tolerance.heading + 1e-9);
  }
}

TEST_P(EveryPlanner, FindsTheSafeWayWhenRiskIsWeighed) {
  const PlanProblem problem = problem_with_weight(5.0);
  const PlanResult result = plan(problem, {});
  ASSERT_EQ(result.status, PlanStatus::solved);
  EXPECT_LT(result.figures.blind_length, 0.5);
  EXPECT_GT(result.figures.length, 20.0);
  expect_collision_free(problem, result);
  expect_the_cost_of_its_path(problem, result);
  expect_from_start_to_goal(problem, result);
  expect_drivable_by_a_car(problem, result);
}

TEST_P(EveryPlanner, FindsTheShortWayWhenItIsNot) {
  const PlanProblem problem = problem_with_weight(0.0);
  const PlanResult result = plan(problem, {});
  ASSERT_EQ(result.status, PlanStatus::solved);
  EXPECT_LT(result.figures.length, 18.0);
  EXPECT_GT(result.figures.blind_length, 9.0);
  expect_collision_free(problem, result);
  expect_the_cost_of_its_path(problem, result);
  expect_from_start_to_goal(problem, result);
  expect_drivable_by_a_car(problem, result);
}

class EveryPlannerOfManyRisks : public EveryPlanner {};

// In every space our own planner, the others in the plane.
std::vector<Case> cases_of_many_risks() {
  std::vector<Case> cases = all_cases();
  std::erase_if(cases, [](const Case& one) { return one.space != MotionSpace::r2 && one.planner != kDefaultPlanner; });
  return cases;
}

TEST_P(EveryPlannerOfManyRisks, KeepsOffWhatARasterCallsRisky) {
  PlanProblem problem = problem_with_weight(5.0);
  problem.alignability.layers.front().values = Grid<float>(problem.alignability.geometry, 0.8f);
  Grid<float> traffic({.resolution = 0.6, .origin = {-0.1, -0.1}, .width = 34, .height = 17}, 0.0f);
  for (int x = 10; x < 20; ++x) {
    for (int y = 10; y < 17; ++y) traffic[Cell{x, y}] = 30.0f;
  }
  problem.query.risk.sources = {
      {.name = "traffic", .weight = 1.5, .risky = 25.0, .safe = 5.0, .values = std::make_shared<const Grid<float>>(traffic)},
      {.name = kClearance,
       .weight = 0.1,
       .risky = 0.4,
       .safe = 0.8,
       .values = std::make_shared<const Grid<float>>(clearance_values(problem.occupancy))}};
  const PlanResult result = plan(problem, {});
  ASSERT_EQ(result.status, PlanStatus::solved);
  const std::vector<double>& risks = result.figures.risk_by_source;
  ASSERT_EQ(risks.size(), 3u);
  EXPECT_EQ(risks[0], 0.0);
  EXPECT_LT(risks[1], 0.5);
  EXPECT_NEAR(result.figures.risk_integral, 1.5 * risks[1] + 0.1 * risks[2], 1e-9);
  EXPECT_GT(result.figures.length, 20.0);
  expect_collision_free(problem, result);
  expect_the_cost_of_its_path(problem, result);
  expect_from_start_to_goal(problem, result);
  problem.query.weight = 0.0;
  EXPECT_LT(plan(problem, {}).figures.length, 18.0);
}

INSTANTIATE_TEST_SUITE_P(Planners, EveryPlannerOfManyRisks, testing::ValuesIn(cases_of_many_risks()), name_of);

INSTANTIATE_TEST_SUITE_P(Planners, EveryPlanner, testing::ValuesIn(all_cases()), name_of);

TEST(Planners, RepeatBySeedUnderIterations) {
  constexpr std::int64_t kIterations = test::kOneOf > 1 ? 500 : 1500;
  for (const char* name : {"rrtstar", "rrtsharp", "rrtxstatic", "lazyprm", "lazyprmstar", "fmtstar", "bfmtstar", "bitstar", "abitstar"}) {
    SCOPED_TRACE(name);
    PlanProblem problem = test::two_corridors();
    problem.query.weight = 5.0;  // the way round: the straight one is the same for every seed
    problem.query.planner = {.name = name, .time = 1.0, .iterations = kIterations, .seed = 7};
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

TEST(Planners, RefuseThoseThatWouldLieWithTheReason) {
  const PlanProblem problem = test::two_corridors();
  for (const std::string& name : refused_planner_names()) {
    const auto refusal = refusal_of_planner(name);
    ASSERT_TRUE(refusal.has_value()) << name;
    EXPECT_NE(refusal->find("'" + name + "' is not offered: it "), std::string::npos) << *refusal;
    PlanProblem asked = problem;
    asked.query.planner.name = name;
    EXPECT_THROW(plan(asked, {}), std::invalid_argument) << name;
  }
  EXPECT_NE(refusal_of_planner("informedrrtstar")->find("straight line"), std::string::npos);
}

TEST(Planners, RefuseInASpaceThoseThatDoNotServeThereWithTheReason) {
  PlanProblem problem = test::two_corridors();
  problem.query.motion = {.space = MotionSpace::dubins, .turning_radius = 1.0};
  problem.query.planner.name = "prmstar";
  EXPECT_THROW(plan(problem, {}), std::invalid_argument);
  EXPECT_NE(refusal_of_planner("prmstar", MotionSpace::dubins)->find("'prmstar' is not offered in the space dubins: its road map"),
            std::string::npos);
  EXPECT_TRUE(refusal_of_planner("fmtstar", MotionSpace::reeds_shepp).has_value());
  EXPECT_FALSE(refusal_of_planner("prmstar", MotionSpace::se2).has_value());
  EXPECT_FALSE(refusal_of_planner("bitstar", MotionSpace::dubins).has_value());
  problem.query.planner.name = "field";
  problem.query.motion.turning_radius = 0.0;
  EXPECT_THROW(plan(problem, {}), std::invalid_argument);
}

TEST(Planners, AreAllInTheDocumentation) {
  const std::string page = read_file(std::filesystem::path(ALIGNABILITY_SOURCE_DIR) / "docs/planners.md", 1u << 20);
  const std::size_t refused = page.find("## Not offered");
  ASSERT_NE(refused, std::string::npos);
  for (const std::string& name : planner_names()) EXPECT_LT(page.find('`' + name + '`'), refused) << name;
  for (const std::string& name : refused_planner_names()) EXPECT_NE(page.find('`' + name + '`', refused), std::string::npos) << name;
}

}  // namespace
}  // namespace alignability
