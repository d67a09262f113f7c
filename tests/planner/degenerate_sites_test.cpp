// SPDX-License-Identifier: BSD-3-Clause
// Sites and queries at the edge of what there is: every planner answers rightly or refuses, with numbers that are numbers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "planner/plan.hpp"
#include "planner/planners.hpp"

namespace alignability {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

// A square of free cells, alike throughout.
PlanProblem square(int cells, double resolution, Eigen::Vector2d origin, float occupancy, float alpha) {
  const GridGeometry grid{.resolution = resolution, .origin = origin, .width = cells, .height = cells};
  PlanProblem problem{OccupancyMap(Grid<float>(grid, occupancy)), {}, {}};
  problem.alignability.geometry = grid;
  problem.alignability.layers.push_back({"alpha", Grid<float>(grid, alpha)});
  problem.query.robot.radius = 0.2;
  problem.query.start = {origin.x() + 0.3 * cells * resolution, origin.y() + 0.5 * cells * resolution, 0.0};
  problem.query.goal = {origin.x() + 0.7 * cells * resolution, origin.y() + 0.5 * cells * resolution, 0.0};
  problem.query.goal_tolerance = {.position = 0.1, .heading = 0.3};
  return problem;
}

PlanProblem hall() { return square(8, 1.0, {0.0, 0.0}, 0.0f, 0.25f); }

PlanProblem hall_with_a_cell_at_the_goal(float occupancy) {
  PlanProblem problem = hall();
  Grid<float> cells(problem.occupancy.geometry(), 0.0f);
  cells[Cell{5, 4}] = occupancy;
  problem.occupancy = OccupancyMap(std::move(cells));
  return problem;
}

PlanProblem with(PlanProblem problem, const std::function<void(PlanQuery&)>& change) {
  change(problem.query);
  return problem;
}

struct Degenerate {
  std::string name;
  PlanProblem problem;
  std::set<PlanStatus> answers;
};

std::vector<Degenerate> degenerate_sites() {
  using enum PlanStatus;
  const auto unknown_alpha = [](UnknownPolicy policy) {
    return with(square(8, 1.0, {0.0, 0.0}, 0.0f, kNan), [&](PlanQuery& query) { query.risk.unknown = policy; });
  };
  return {
      {"a map of one cell", square(1, 1.0, {0.0, 0.0}, 0.0f, 0.5f), {solved}},
      {"no free cell", square(8, 1.0, {0.0, 0.0}, 1.0f, 0.5f), {start_in_collision}},
      {"all unknown", square(8, 1.0, {0.0, 0.0}, kNan, 0.5f), {start_in_collision}},
      {"all free", hall(), {solved}},
      {"alpha 0 throughout", square(8, 1.0, {0.0, 0.0}, 0.0f, 0.0f), {solved}},
      {"alpha 1 throughout", square(8, 1.0, {0.0, 0.0}, 0.0f, 1.0f), {solved}},
      {"alpha unknown throughout", unknown_alpha(UnknownPolicy::risky), {solved}},
      {"alpha unknown and neutral", unknown_alpha(UnknownPolicy::neutral), {solved}},
      {"alpha unknown and blocked", unknown_alpha(UnknownPolicy::blocked), {start_in_collision}},
      {"start is goal", with(hall(), [](PlanQuery& query) { query.goal = query.start; }), {solved}},
      {"goal in a wall", hall_with_a_cell_at_the_goal(1.0f), {goal_in_collision}},
      {"goal in the unknown", hall_with_a_cell_at_the_goal(kNan), {goal_in_collision}},
      {"goal off the map", with(hall(), [](PlanQuery& query) { query.goal.x = 80.0; }), {goal_outside_map}},
      {"start off the map", with(hall(), [](PlanQuery& query) { query.start.x = -1e9; }), {start_outside_map}},
      {"no weight", with(hall(), [](PlanQuery& query) { query.weight = 0.0; }), {solved}},
      {"weight 1e9", with(hall(), [](PlanQuery& query) { query.weight = 1e9; }), {solved}},
      {"a robot as wide as the map", with(hall(), [](PlanQuery& query) { query.robot.radius = 4.0; }), {start_in_collision}},
      {"a point for a robot", with(hall(), [](PlanQuery& query) { query.robot.radius = 1e-9; }), {solved}},
      {"a million metres off", square(8, 1.0, {1e6, -1e6}, 0.0f, 0.25f), {solved}},
      {"a tight tolerance",
       with(hall(), [](PlanQuery& query) { query.goal_tolerance = {.position = 1e-6, .heading = 1e-6}; }),
       {solved, timeout}},
  };
}

void expect_sound(const PlanResult& result, const Degenerate& site) {
  EXPECT_TRUE(std::isfinite(result.seconds) && result.seconds >= 0.0);
  if (result.status != PlanStatus::solved) {
    EXPECT_TRUE(result.path.empty());
    return;
  }
  const PathFigures& figures = result.figures;
  for (const double value : {result.cost, figures.length, figures.turned, figures.risk_integral, figures.blind_length,
                             figures.longest_blind, figures.evaluated_length}) {
    EXPECT_TRUE(std::isfinite(value) && value >= 0.0) << value;
  }
  if (result.lower_bound) {
    EXPECT_LE(*result.lower_bound, result.cost * (1.0 + 1e-9) + 1e-9);
  }
  const PlanQuery& query = site.problem.query;
  ASSERT_FALSE(result.path.empty());
  EXPECT_EQ(result.path.front().position(), query.start.position());
  EXPECT_LE((result.path.back().position() - query.goal.position()).norm(), query.goal_tolerance.position + 1e-9);
  EXPECT_LE(figures.blind_length, figures.length * (1.0 + 1e-9));
}

class EveryPlannerAtTheEdge : public testing::TestWithParam<std::tuple<std::string, MotionSpace>> {};

TEST_P(EveryPlannerAtTheEdge, AnswersRightlyOrRefuses) {
  const auto& [planner, space] = GetParam();
  for (Degenerate& site : degenerate_sites()) {
    SCOPED_TRACE(site.name);
    site.problem.query.motion.space = space;
    // PRM's iterations are rounds of a loop that looks on while another thread samples.
    const std::int64_t iterations = planner.starts_with("prm") ? 5000 : 600;
    site.problem.query.planner = {.name = planner, .time = 1.0, .iterations = iterations, .seed = 1};
    const PlanResult result = plan(site.problem, {});
    EXPECT_TRUE(site.answers.contains(result.status)) << to_string(result.status);
    expect_sound(result, site);
  }
}

std::string name_of(const testing::TestParamInfo<std::tuple<std::string, MotionSpace>>& tested) {
  return std::get<0>(tested.param) + '_' + to_string(std::get<1>(tested.param));
}

INSTANTIATE_TEST_SUITE_P(In, EveryPlannerAtTheEdge,
                         testing::Combine(testing::ValuesIn(planner_names()), testing::Values(MotionSpace::r2, MotionSpace::se2)), name_of);

}  // namespace
}  // namespace alignability
