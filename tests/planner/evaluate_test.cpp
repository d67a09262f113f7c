// SPDX-License-Identifier: BSD-3-Clause
#include "planner/evaluate.hpp"

#include <gmock/gmock.h>

#include <random>

#include "core/range.hpp"
#include "planner/drivable_area.hpp"
#include "planner/headings.hpp"
#include "planner/route_file.hpp"
#include "tests/core/temporary_folder.hpp"
#include "tests/planner/collision_oracle.hpp"
#include "tests/planner/two_corridors.hpp"

namespace alignability {
namespace {

using Path = std::vector<Pose2>;

constexpr double kUp = std::numbers::pi / 2.0;

// 10 × 6 m without walls, poor (α = 0) up to x = 5 and safe (α = 0.5) beyond.
PlanProblem half_poor() {
  Grid<float> alpha({.resolution = 1.0, .origin = {0.0, 0.0}, .width = 10, .height = 6}, 0.5f);
  for (int y = 0; y < 6; ++y) {
    for (int x = 0; x < 5; ++x) alpha[Cell{x, y}] = 0.0f;
  }
  PlanProblem problem{OccupancyMap(Grid<float>({.resolution = 0.1, .origin = {0.0, 0.0}, .width = 100, .height = 60}, 0.0f)), {}, {}};
  problem.alignability.geometry = alpha.geometry();
  problem.alignability.layers.push_back({"alpha", std::move(alpha)});
  problem.query.robot.radius = 0.4;
  problem.query.weight = 3.0;
  return problem;
}

Route path_route(Path path) { return {.path = std::move(path), .graph = {}, .remarks = {}}; }

WayEvaluation evaluated(const PlanProblem& problem, Path path) {
  return evaluate(path_route(std::move(path)), problem.query, PlanningFields(problem)).total;
}

void expect_equal(const WayEvaluation& way, double cost, const PathFigures& figures) {
  EXPECT_NEAR(way.cost, cost, 1e-9);
  EXPECT_NEAR(way.figures.length, figures.length, 1e-9);
  EXPECT_NEAR(way.figures.turned, figures.turned, 1e-9);
  EXPECT_NEAR(way.figures.risk_integral, figures.risk_integral, 1e-9);
  EXPECT_NEAR(way.figures.blind_length, figures.blind_length, 1e-9);
  EXPECT_NEAR(way.figures.longest_blind, figures.longest_blind, 1e-9);
  EXPECT_NEAR(way.figures.alpha_mean, figures.alpha_mean, 1e-9);
  EXPECT_NEAR(way.figures.alpha_min, figures.alpha_min, 1e-9);
}

TEST(Evaluate, SumsTheRiskOfEachSourceOverEdges) {
  PlanProblem problem = half_poor();
  // 1 from x = 8 on, 0 up to x = 7.
  Grid<float> traffic({.resolution = 1.0, .origin = {-0.5, -1.0}, .width = 11, .height = 8}, 0.0f);
  for (int y = 0; y < 8; ++y) {
    for (int x = 8; x < 11; ++x) traffic[Cell{x, y}] = 1.0f;
  }
  problem.query.risk.sources = {{.name = "traffic", .weight = 2.0, .values = std::make_shared<const Grid<float>>(traffic)}};
  Route graph;
  graph.graph.nodes = {{"a", {}}, {"b", {}}};
  graph.graph.edges = {{"one", 0, 1, {{1.0, 3.0, 0.0}, {9.0, 3.0, 0.0}}}, {"two", 1, 0, {{9.0, 2.0, 0.0}, {7.5, 2.0, 0.0}}}};
  const Evaluation evaluation = evaluate(graph, problem.query, PlanningFields(problem));
  ASSERT_EQ(evaluation.edges.size(), 2u);
  const std::vector<double>& one = evaluation.edges[0].way.figures.risk_by_source;
  const std::vector<double>& two = evaluation.edges[1].way.figures.risk_by_source;
  EXPECT_EQ(evaluation.edges[0].edge.id, "one");
  EXPECT_NEAR(one[0], 4.0, 1e-9);
  EXPECT_NEAR(one[1], 1.5, 1e-9);
  EXPECT_NEAR(two[0], 0.0, 1e-9);
  EXPECT_NEAR(two[1], 1.0 + 0.375, 1e-9);
  EXPECT_NEAR(evaluation.total.figures.risk_by_source[1], 1.5 + 1.375, 1e-9);
  EXPECT_NEAR(evaluation.total.figures.risk_integral, 4.0 + 2.0 * 2.875, 1e-9);
  EXPECT_NEAR(evaluation.total.cost, 9.5 + 3.0 * (4.0 + 2.0 * 2.875), 1e-9);
}

TEST(Evaluate, GivesTheFiguresThatPencilAndPaperDo) {
  // From x = 4.5 to 5.5 risk falls from 1 to 0 and α rises from 0 to 0.5: it is 0.1 at 4.7.
  const PathFigures figures{.length = 10.0,
                            .turned = kUp,
                            .risk_integral = 4.0,
                            .blind_length = 3.7,
                            .longest_blind = 3.7,
                            .evaluated_length = 10.0,
                            .alpha_mean = 0.3,
                            .alpha_min = 0.0};
  const Path path{{1, 3, 0}, {9, 3, 0}, {9, 3, kUp}, {9, 5, kUp}};
  PlanProblem problem = half_poor();
  const WayEvaluation way = evaluated(problem, path);
  EXPECT_EQ(way.status, RouteStatus::solved);
  EXPECT_EQ(way.obstruction, std::nullopt);
  expect_equal(way, 10.0 + 3.0 * 4.0 + 0.2 * kUp, figures);
  problem.query.motion.space = MotionSpace::r2;
  expect_equal(evaluated(problem, path), 10.0 + 3.0 * 4.0, figures);
}

TEST(Evaluate, GivesAPlannedPathTheFiguresOfItsPlan) {
  const test::TemporaryFolder folder;
  for (const MotionSpace space : {MotionSpace::se2, MotionSpace::r2}) {
    PlanProblem problem = test::two_corridors();
    problem.query.motion.space = space;
    problem.query.planner.iterations = 3000;
    const PlanningFields fields(problem);
    const PlanResult planned = plan(problem.query, fields, {});
    ASSERT_EQ(planned.status, PlanStatus::solved);
    std::string csv = "x,y,yaw\n";
    for (const PathSample& at : sample(planned.path, *fields.risk, 0.1)) {
      csv += to_text(at.pose.x) + ',' + to_text(at.pose.y) + ',' + to_text(at.pose.yaw) + '\n';
    }
    const Route route = read_route(folder.write("plan.csv", csv), {});
    const Evaluation evaluation = evaluate(route, problem.query, fields);
    EXPECT_EQ(evaluation.total.status, RouteStatus::solved);
    expect_equal(evaluation.total, planned.cost, planned.figures);
  }
}

TEST(Evaluate, FindsWhereTheRobotFirstCollides) {
  const PlanProblem problem = test::two_corridors();  // a disk of 0.4 m; a block from x = 4 to 16 and y = 3 to 7.5, walls of 0.1 m
  const WayEvaluation into = evaluated(problem, {{2, 8.5, 0}, {2, 5, 0}, {18, 5, 0}});
  EXPECT_EQ(into.status, RouteStatus::in_collision);
  ASSERT_TRUE(into.obstruction.has_value());
  EXPECT_NEAR(into.obstruction->x, 3.6, 1e-6);
  EXPECT_NEAR(into.obstruction->y, 5.0, 1e-6);
  EXPECT_NEAR(into.figures.length, 19.5, 1e-12);
  const WayEvaluation within = evaluated(problem, {{10, 5, 0}, {18, 5, 0}});
  EXPECT_EQ(within.status, RouteStatus::in_collision);
  EXPECT_EQ(within.obstruction, (Pose2{10, 5, 0}));
  EXPECT_EQ(evaluated(problem, {{2, 2.599, 0}, {18, 2.599, 0}}).status, RouteStatus::solved);
  EXPECT_EQ(evaluated(problem, {{2, 2.601, 0}, {18, 2.601, 0}}).status, RouteStatus::in_collision);
}

TEST(Evaluate, FindsAWallOfOneCellBetweenTwoPoses) {
  PlanProblem problem = half_poor();
  Grid<float> occupancy(problem.occupancy.geometry(), 0.0f);
  occupancy[Cell{52, 30}] = 1.0f;
  problem.occupancy = OccupancyMap(std::move(occupancy));
  problem.query.robot.radius = 0.01;
  const WayEvaluation way = evaluated(problem, {{0.5, 3.05, 0}, {9.5, 3.05, 0}});
  EXPECT_EQ(way.status, RouteStatus::in_collision);
  EXPECT_NEAR(way.obstruction->x, 5.19, 1e-6);
}

TEST(Evaluate, SaysWhereTheRobotLeavesTheMap) {
  const PlanProblem problem = half_poor();
  const WayEvaluation way = evaluated(problem, {{5, 3, 0}, {5, 3, kUp}, {5, 30, kUp}});
  EXPECT_EQ(way.status, RouteStatus::outside_map);
  EXPECT_NEAR(way.obstruction->y, 5.6, 1e-6);
  EXPECT_NEAR(way.figures.length, 27.0, 1e-12);
  EXPECT_EQ(evaluated(problem, {{-3, 3, 0}, {5, 3, 0}}).status, RouteStatus::outside_map);
  EXPECT_EQ(evaluated(problem, {{-3, 3, 0}, {5, 3, 0}}).obstruction, (Pose2{-3, 3, 0}));
}

TEST(Evaluate, SaysWhereNobodyEvaluatedAPlaceThatIsThenBlocked) {
  PlanProblem problem = half_poor();
  for (int y = 0; y < 6; ++y) {
    for (int x = 6; x < 9; ++x) problem.alignability.layers.front().values[Cell{x, y}] = std::numeric_limits<float>::quiet_NaN();
  }
  const Path path{{1, 3, 0}, {9, 3, 0}};
  EXPECT_EQ(evaluated(problem, path).status, RouteStatus::solved);
  problem.query.risk.unknown = UnknownPolicy::blocked;
  const WayEvaluation way = evaluated(problem, path);
  EXPECT_EQ(way.status, RouteStatus::unevaluated);
  EXPECT_NEAR(way.obstruction->x, 7.0, 1e-6);  // cells 6 and 8 border evaluated ones
}

class RandomWays : public testing::TestWithParam<Robot> {};

TEST_P(RandomWays, AreObstructedWhereAnOracleFindsACollision) {
  std::mt19937_64 engine(17);
  std::uniform_real_distribution<double> x(2.2, 7.8), y(2.2, 5.8), yaw(-3.0, 3.0);
  std::bernoulli_distribution occupied(0.002);
  Grid<float> occupancy({.resolution = 0.1, .origin = {0.0, 0.0}, .width = 100, .height = 80}, 0.0f);
  for (std::size_t i = 0; i < occupancy.geometry().size(); ++i) occupancy[i] = occupied(engine) ? 1.0f : 0.0f;
  PlanProblem problem = half_poor();
  problem.query.robot = GetParam();
  problem.occupancy = OccupancyMap(std::move(occupancy));
  const PlanningFields fields(problem);
  const DrivableArea area(fields.clearance, fields.risk, problem.query.robot);
  constexpr int kWays = 100;
  int solved = 0;
  int obstructed_on_the_way = 0;
  for (int i = 0; i < kWays; ++i) {
    SCOPED_TRACE(i);
    const Path path{{x(engine), y(engine), yaw(engine)}, {x(engine), y(engine), yaw(engine)}};
    const WayEvaluation way = evaluate(path_route(path), problem.query, fields).total;
    const auto collision = test::first_collision(problem.occupancy, problem.query.robot, path);
    EXPECT_TRUE(!collision || way.status == RouteStatus::in_collision);
    solved += way.status == RouteStatus::solved ? 1 : 0;
    if (!way.obstruction) continue;
    EXPECT_LT(area.clearance(*way.obstruction), 2e-4);
    if (*way.obstruction == path[0]) continue;
    ++obstructed_on_the_way;
    const Path before{path[0], between(path[0], *way.obstruction, 1.0 - 1e-5)};
    EXPECT_EQ(test::first_collision(problem.occupancy, problem.query.robot, before), std::nullopt);
  }
  EXPECT_GT(solved, 5);
  EXPECT_GT(obstructed_on_the_way, 20);
}

INSTANTIATE_TEST_SUITE_P(DiskAndTruck, RandomWays,
                         testing::Values(Robot{.radius = 0.3, .footprint = {}},
                                         Robot{.radius = 0.0, .footprint = {{0.9, 0.3}, {-0.3, 0.3}, {-0.3, -0.3}, {0.9, -0.3}}}));

// An aisle 1.2 m wide to the right, at its end another upwards.
PlanProblem bent_aisle() {
  PlanProblem problem = half_poor();
  Grid<float> occupancy(problem.occupancy.geometry(), 1.0f);
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < 100; ++x) {
      const bool rightwards = y >= 4 && y < 16 && x >= 2 && x < 90;
      const bool upwards = x >= 78 && x < 90 && y >= 4;
      if (rightwards || upwards) occupancy[Cell{x, y}] = 0.0f;
    }
  }
  problem.occupancy = OccupancyMap(std::move(occupancy));
  problem.query.robot = {.radius = 0.0, .footprint = {{0.5, 0.4}, {-0.5, 0.4}, {-0.5, -0.4}, {0.5, -0.4}}};
  return problem;
}

TEST(Evaluate, LetsARobotWithAFootprintLookStraightAheadUntilItTurnsOnTheSpot) {
  PlanProblem problem = bent_aisle();
  problem.query.robot.footprint = {{0.4, 0.4}, {-0.4, 0.4}, {-0.4, -0.4}, {0.4, -0.4}};  // its corners 0.57 m off, and 0.6 m of room
  const Path ahead = looking_ahead({{1, 1, 0}, {8.4, 1, 0}, {8.4, 5, 0}}, 0.0);
  EXPECT_EQ(evaluated(problem, turning_on_the_spot(ahead)).status, RouteStatus::solved);
  problem.query.robot.footprint = {{0.8, 0.55}, {-0.8, 0.55}, {-0.8, -0.55}, {0.8, -0.55}};
  const WayEvaluation way = evaluated(problem, turning_on_the_spot(ahead));
  EXPECT_EQ(way.status, RouteStatus::in_collision);
  EXPECT_NEAR(way.obstruction->x, 8.2, 1e-6);  // where its front reaches the end of the aisle
  EXPECT_NEAR(way.obstruction->y, 1.0, 1e-9);
}

TEST(Evaluate, FindsTheTurnThatARobotHasNoRoomFor) {
  const PlanProblem problem = bent_aisle();  // corners 0.64 m off, and 0.6 m of room
  const WayEvaluation way = evaluated(problem, turning_on_the_spot(looking_ahead({{1, 1, 0}, {8.4, 1, 0}, {8.4, 5, 0}}, 0.0)));
  EXPECT_EQ(way.status, RouteStatus::in_collision);
  EXPECT_EQ(way.obstruction->position(), Eigen::Vector2d(8.4, 1.0));
  EXPECT_GT(way.obstruction->yaw, 0.1);
  EXPECT_LT(way.obstruction->yaw, kUp - 0.1);
}

TEST(Evaluate, ScoresARobotThatStands) {
  const WayEvaluation way = evaluated(half_poor(), {{2, 2, 1}});
  EXPECT_EQ(way.status, RouteStatus::solved);
  EXPECT_EQ(way.cost, 0.0);
  EXPECT_EQ(way.figures.alpha_min, 0.0);
}

TEST(Evaluate, RefusesARouteThatLeadsNowhere) { EXPECT_THROW(evaluated(half_poor(), {}), std::invalid_argument); }

// A triangle of lanes in half_poor, one of them both ways, and one off the map.
Route triangle() {
  Route route;
  route.graph.nodes = {{"A", {1, 3}}, {"B", {9, 3}}, {"C", {9, 5}}, {"D", {9, 9}}};
  route.graph.edges = {{"poor", 0, 1, {{1, 3, 0}, {9, 3, 0}}},
                       {"rich", 1, 2, {{9, 3, kUp}, {9, 5, kUp}}},
                       {"back", 2, 1, {{9, 5, -kUp}, {9, 3, -kUp}}},
                       {"off", 2, 3, {{9, 5, kUp}, {9, 9, kUp}}}};
  return route;
}

std::vector<std::string> ids(const Evaluation& evaluation) {
  std::vector<std::string> names;
  for (const EdgeEvaluation& edge : evaluation.edges) names.push_back(edge.edge.id);
  return names;
}

TEST(Evaluate, ScoresEachEdgeOfAGraphTheWorstFirst) {
  const PlanProblem problem = half_poor();
  const Evaluation evaluation = evaluate(triangle(), problem.query, PlanningFields(problem));
  EXPECT_THAT(ids(evaluation), testing::ElementsAre("off", "poor", "rich", "back"));
  EXPECT_EQ(evaluation.edges[0].way.status, RouteStatus::outside_map);
  EXPECT_EQ(evaluation.edges[1].way.status, RouteStatus::solved);
  for (const EdgeEvaluation& edge : evaluation.edges) {
    const WayEvaluation alone = evaluated(problem, edge.edge.path);
    EXPECT_EQ(edge.way.cost, alone.cost);
    EXPECT_EQ(edge.way.figures.blind_length, alone.figures.blind_length);
  }
}

TEST(Evaluate, AddsUpTheEdgesOfAGraph) {
  const PlanProblem problem = half_poor();
  Route route = triangle();
  const PlanningFields fields(problem);
  EXPECT_EQ(evaluate(route, problem.query, fields).total.status, RouteStatus::outside_map);
  route.graph.edges.pop_back();
  const WayEvaluation total = evaluate(route, problem.query, fields).total;
  EXPECT_EQ(total.status, RouteStatus::solved);
  expect_equal(total, 12.0 + 3.0 * 4.0,
               {.length = 12.0,
                .turned = 0.0,
                .risk_integral = 4.0,
                .blind_length = 3.7,
                .longest_blind = 3.7,
                .evaluated_length = 12.0,
                .alpha_mean = 4.0 / 12.0,
                .alpha_min = 0.0});
}

TEST(Evaluate, KeepsUnevaluatedEdgesOutOfTheMean) {
  PlanProblem problem = half_poor();
  Grid<float>& alpha = problem.alignability.layers.front().values;
  alpha = Grid<float>(alpha.geometry(), std::numeric_limits<float>::quiet_NaN());
  const WayEvaluation none = evaluate(triangle(), problem.query, PlanningFields(problem)).total;
  EXPECT_TRUE(std::isnan(none.figures.alpha_mean) && std::isnan(none.figures.alpha_min));
  EXPECT_EQ(none.figures.blind_length, none.figures.length);
}

TEST(PathAlong, JoinsEdgesAtTheNodesThatTheyShare) {
  const std::vector<std::string> nodes{"A", "B", "C", "B"};
  const Path path = path_along(triangle().graph, nodes);
  EXPECT_EQ(path, (Path{{1, 3, 0}, {9, 3, 0}, {9, 3, kUp}, {9, 5, kUp}, {9, 5, -kUp}, {9, 3, -kUp}}));
  const WayEvaluation way = evaluated(half_poor(), path);
  EXPECT_NEAR(way.figures.length, 12.0, 1e-12);
  EXPECT_NEAR(way.figures.turned, 3.0 * kUp, 1e-12);
}

TEST(PathAlong, GoesOnWithoutATurnWhereTheNextEdgeDoes) {
  const std::vector<std::string> nodes{"B", "C", "D"};
  EXPECT_EQ(path_along(triangle().graph, nodes), (Path{{9, 3, kUp}, {9, 5, kUp}, {9, 9, kUp}}));
}

TEST(PathAlong, RefusesNodesThatNoEdgeJoins) {
  RouteGraph graph = triangle().graph;
  const auto message = [&](const std::vector<std::string>& nodes) -> std::string {
    try {
      path_along(graph, nodes);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message({"A", "C"}), "no edge leads from node 'A' to node 'C'");
  EXPECT_EQ(message({"A", "B", "A"}), "no edge leads from node 'B' to node 'A', though one leads back");
  EXPECT_EQ(message({"A", "E"}), "there is no node 'E'");
  EXPECT_EQ(message({"A"}), "a path along nodes needs at least two of them");
  graph.edges.push_back(graph.edges[0]);
  graph.edges.back().id = "twin";
  EXPECT_EQ(message({"A", "B"}), "");
  graph.edges.back().path.insert(graph.edges.back().path.begin() + 1, Pose2{5, 1, 0});
  EXPECT_EQ(message({"A", "B"}), "the edges 'poor' and 'twin' lead from node 'A' to node 'B' on different ways");
}

}  // namespace
}  // namespace alignability
