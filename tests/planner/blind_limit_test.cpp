// SPDX-License-Identifier: BSD-3-Clause
#include "planner/blind_limit.hpp"

#include <gtest/gtest.h>

#include <map>
#include <queue>

#include "planner/limited_path.hpp"
#include "planner/limited_search.hpp"
#include "planner/plan.hpp"
#include "tests/planner/blind_walk.hpp"
#include "tests/planner/island.hpp"
#include "tests/planner/patience.hpp"
#include "tests/planner/plane_site.hpp"
#include "tests/planner/random_sites.hpp"

namespace alignability {
namespace {

TEST(BlindLimit, CountsAsAWalkByMillimetresDoes) {
  std::mt19937_64 engine(5);
  std::uniform_real_distribution<double> x(-2.9, 3.0), y(2.1, 6.0);
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    PlanProblem problem = test::random_site(seed);
    problem.query.risk = {
        .alpha_critical = 0.2, .alpha_safe = 0.3, .unknown = seed % 2 == 0 ? UnknownPolicy::risky : UnknownPolicy::neutral};
    const RiskField risk(problem.alignability, problem.occupancy, problem.query.risk);
    std::vector<Pose2> path;
    for (int i = 0; i < 6; ++i) path.push_back({x(engine), y(engine), 0.0});
    EXPECT_NEAR(longest_unrecovered(path, risk, 0.7), test::walked_unrecovered(path, risk, 0.7), 0.01);
  }
}

TEST(BlindLimit, KnowsOfAWayOfOneGroundWhatWalkingItTells) {
  const PlanProblem problem = test::problem_with_an_island();
  const RiskField risk(problem.alignability, problem.occupancy, {});
  const BlindLimit limit{.most = 8.0, .recovery = 1.5};
  std::mt19937_64 engine(6);
  std::uniform_real_distribution<double> x(0.0, 30.0), y(0.0, 12.0), metres(0.0, 8.0);
  int of_one_ground = 0, broken = 0;
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector2d from(x(engine), y(engine)), to = from + Eigen::Vector2d(x(engine) - 15.0, y(engine) - 6.0) / 8.0;
    const BlindState state{metres(engine), i % 2 == 0 ? 0.0 : 0.8};
    const BlindLimit::Change change = limit.change(from, to, risk);
    const auto known = limit.after(state, change, from, to, risk), walked = limit.after(state, from, to, risk);
    ASSERT_EQ(known.has_value(), walked.has_value());
    of_one_ground += change.all ? 1 : 0;
    broken += walked ? 0 : 1;
    if (!walked) continue;
    EXPECT_NEAR(known->blind, walked->blind, 1e-9);
    EXPECT_NEAR(known->safe, walked->safe, 1e-9);
  }
  EXPECT_GT(of_one_ground, 200);
  EXPECT_GT(broken, 20);
}

PlanResult plan_with(std::optional<double> most, double recovery) {
  PlanProblem problem = test::problem_with_an_island();
  problem.query.max_blind_distance = most;
  problem.query.recovery_distance = recovery;
  return plan(problem, {});
}

class MaxBlindDistance : public testing::Test {
 protected:
  // The way straight across has some 24 m of blind ground; over the island two times 8 to 9.
  void expect_kept(const PlanResult& result, double most, double recovery) const {
    ASSERT_EQ(result.status, PlanStatus::solved);
    // The path may be safe for no longer than it must, which steps of a millimetre do not tell.
    EXPECT_LE(test::walked_unrecovered(result.path, risk, recovery - 0.01), most + 0.01);
    EXPECT_LE(*result.longest_unrecovered, most);
  }

  PlanProblem problem = test::problem_with_an_island();
  RiskField risk{problem.alignability, problem.occupancy, {}};
};

TEST_F(MaxBlindDistance, LeavesAPathAloneThatKeepsIt) { EXPECT_EQ(plan_with(30.0, 1.0).path, plan_with(std::nullopt, 1.0).path); }

TEST_F(MaxBlindDistance, LeadsOverTheIslandWhereTheRobotFindsItself) {
  const PlanResult result = plan_with(12.0, 1.0);
  expect_kept(result, 12.0, 1.0);
  EXPECT_GT(result.figures.blind_length, 12.0);
  EXPECT_LT(result.figures.length, 29.0);
}

TEST_F(MaxBlindDistance, LeadsAlongTheIslandAsFarAsFindingItselfTakes) {
  const PlanResult brief = plan_with(12.0, 1.0), thorough = plan_with(12.0, 5.0);
  expect_kept(thorough, 12.0, 5.0);
  EXPECT_GE(thorough.cost, brief.cost - 1e-6);
}

TEST_F(MaxBlindDistance, LeadsAllTheWayAroundWhereTheIslandIsTooSmall) {
  const PlanResult result = plan_with(12.0, 30.0);
  expect_kept(result, 12.0, 30.0);
  EXPECT_GT(result.figures.length, 34.0);
}

TEST_F(MaxBlindDistance, SaysWhichLimitWouldDo) {
  problem.alignability.layers.front().values = Grid<float>(problem.alignability.geometry, 0.02f);
  problem.query.max_blind_distance = 10.0;
  const PlanResult result = plan(problem, {});
  EXPECT_EQ(result.status, PlanStatus::infeasible);
  ASSERT_TRUE(result.smallest_max_blind_distance.has_value());
  EXPECT_NEAR(*result.smallest_max_blind_distance, 27.0, 0.3);
  problem.query.max_blind_distance = *result.smallest_max_blind_distance;
  EXPECT_EQ(plan(problem, {}).status, PlanStatus::solved);
}

TEST_F(MaxBlindDistance, CountsNoFurtherThanTheTolerance) {
  problem.query.start = {1.5, 1.0, 0.0};
  problem.query.goal = {8.0, 4.5, 0.0};
  problem.query.max_blind_distance = 0.1;
  const auto smallest = [&](double tolerance) {
    problem.query.goal_tolerance.position = tolerance;
    const PlanResult result = plan(problem, {});
    EXPECT_EQ(result.status, PlanStatus::infeasible);
    return result.smallest_max_blind_distance.value_or(0.0);
  };
  const double near = smallest(0.01), far = smallest(1.0);
  EXPECT_NEAR(near - far, 1.0, 0.1);
  problem.query.max_blind_distance = far + 0.02;
  const PlanResult result = plan(problem, {});
  expect_kept(result, far + 0.02, 1.0);
  EXPECT_LE((result.path.back().position() - problem.query.goal.position()).norm(), 1.0);
}

TEST_F(MaxBlindDistance, IsForOurPlanner) {
  problem.query.max_blind_distance = 10.0;
  problem.query.planner.name = "bitstar";
  EXPECT_THROW(plan(problem, {}), std::invalid_argument);
}

// The least cost over the same places and ways, by Dijkstra's algorithm over places, blind metres and safe metres, both counted by
// two centimetres and rounded in the robot's favour or to its cost: the optimum is no less than the one and no more than the other.
double least_cost(const PlanarMotion& motion, const BlindLimit& limit, double spacing, const Eigen::Vector2d& start,
                  const Eigen::Vector2d& goal, double (*rounded)(double)) {
  constexpr double kUnit = 0.02;
  const GridGeometry& map = motion.clearance->geometry();
  const int width = static_cast<int>(map.extent().x() / spacing), height = static_cast<int>(map.extent().y() / spacing);
  std::vector<Eigen::Vector2d> places;
  for (int i = 0; i < width * height; ++i) places.push_back(map.origin + spacing * Eigen::Vector2d(i % width + 0.5, i / width + 0.5));
  places.push_back(start);
  places.push_back(goal);
  const int from_start = width * height, to_goal = from_start + 1;
  const auto are_joined = [&](int a, int b) {
    if (a > b) std::swap(a, b);
    if (a == from_start) return true;
    if (b >= from_start) {
      const Eigen::Array2i cell = ((places[static_cast<std::size_t>(b)] - map.origin) / spacing).array().floor().cast<int>();
      return std::abs(a % width - cell.x()) <= 2 && std::abs(a / width - cell.y()) <= 2;
    }
    const int dx = std::abs(a % width - b % width), dy = std::abs(a / width - b / width);
    return dx <= 2 && dy <= 2 && (dx == 1 || dy == 1 || dx + dy == 1);
  };
  std::vector<std::vector<int>> joined(places.size());
  for (int a = 0; a <= to_goal; ++a) {
    for (int b = 0; b <= to_goal; ++b) {
      const bool is_way =
          a != b && are_joined(a, b) && motion.is_allowed(places[static_cast<std::size_t>(a)], places[static_cast<std::size_t>(b)]);
      if (is_way) joined[static_cast<std::size_t>(a)].push_back(b);
    }
  }
  using State = std::tuple<int, int, int>;  // place, blind, safe
  std::map<State, double> best;
  std::priority_queue<std::pair<double, State>, std::vector<std::pair<double, State>>, std::greater<>> queue;
  const int recovered = static_cast<int>(std::ceil(limit.recovery / kUnit));
  queue.push({0.0, {from_start, 0, recovered}});
  while (!queue.empty()) {
    const auto [cost, state] = queue.top();
    queue.pop();
    const auto [place, blind, safe] = state;
    if (place == to_goal) return cost;
    if (!best.emplace(state, cost).second) continue;
    for (const int next : joined[static_cast<std::size_t>(place)]) {
      const Eigen::Vector2d &a = places[static_cast<std::size_t>(place)], &b = places[static_cast<std::size_t>(next)];
      const auto after = limit.after({blind * kUnit, safe * kUnit}, a, b, *motion.risk);
      if (!after) continue;
      const State then{next, static_cast<int>(rounded(after->blind / kUnit)),
                       std::min(recovered, static_cast<int>(std::floor(after->safe / kUnit + (rounded(0.5) == 0.0 ? 1.0 : 0.0))))};
      if (!best.contains(then)) queue.push({cost + motion.cost(a, b), then});
    }
  }
  return std::numeric_limits<double>::infinity();
}

TEST(LimitedSearch, AgreesWithBruteForceOnSmallMaps) {
  std::mt19937_64 engine(8);
  std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
  int limited = 0;
  for (int trial = 0; trial < 10 / test::kOneOf; ++trial) {
    SCOPED_TRACE(trial);
    const GridGeometry map{.resolution = 0.25, .width = 28, .height = 20};
    const PlanProblem problem{
        OccupancyMap(Grid<float>(map, 0.0f)), test::alignability_by_metre(map, [&] { return uniform(engine) < 0.7f ? 0.02f : 0.6f; }), {}};
    const PlanningFields fields(problem);
    const PlanarMotion motion{fields.risk, fields.clearance, 1.0, 0.2};
    const Eigen::Vector2d start(0.6, 2.6), goal(6.4, 2.4);
    for (const double most : {0.6, 1.2}) {
      const BlindLimit limit{.most = most, .recovery = 0.8};
      const detail::LimitedSearch search(motion, {.blind = limit}, 0.5, {start, goal}, {});
      const auto path = search.cheapest(0.0);
      const double at_least = least_cost(motion, limit, 0.5, start, goal, [](double value) { return std::floor(value); });
      const double at_most = least_cost(motion, limit, 0.5, start, goal, [](double value) { return std::ceil(value); });
      if (path) {
        EXPECT_GE(test::cost_of(*path, motion), at_least - 1e-9);
        EXPECT_LE(test::cost_of(*path, motion), at_most + 1e-9);
        EXPECT_TRUE(keeps(*path, motion, {.blind = limit}));
      } else {
        EXPECT_EQ(at_most, std::numeric_limits<double>::infinity());
      }
      EXPECT_EQ(search.any({.blind = limit}, 0.0).has_value(), path.has_value());
      const detail::LimitedSearch unlimited(motion, {.blind = BlindLimit{.most = 100.0}}, 0.5, {start, goal}, {});
      limited += at_least > 1.01 * test::cost_of(*unlimited.cheapest(0.0), motion) ? 1 : 0;
    }
  }
  EXPECT_GT(limited, 5 / test::kOneOf);
}

}  // namespace
}  // namespace alignability
