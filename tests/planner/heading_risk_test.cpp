// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>

#include <random>

#include "planner/alignability_objective.hpp"
#include "planner/cost_bound.hpp"
#include "planner/evaluate.hpp"
#include "planner/headings.hpp"
#include "planner/poses.hpp"
#include "planner/station_matrix.hpp"
#include "tests/costmap/heading_maps.hpp"
#include "tests/planner/patience.hpp"

namespace alignability {
namespace {

namespace ob = ompl::base;

constexpr double kWest = std::numbers::pi;

using AlphaByHeading = std::function<float(const Eigen::Vector2d&, double)>;

// Rich looking east, poor looking west, whatever the place.
float looking_east(const Eigen::Vector2d&, double yaw) { return static_cast<float>(0.25 + 0.25 * std::cos(yaw)); }

// A hall of 24 × 12 m.
PlanProblem hall(const AlphaByHeading& alpha, const std::function<bool(const Eigen::Vector2d&)>& is_wall) {
  Grid<float> occupancy({.resolution = 0.1, .width = 240, .height = 120}, 0.0f);
  for (std::size_t i = 0; i < occupancy.values().size(); ++i) {
    const Eigen::Vector2d at = occupancy.geometry().center(occupancy.geometry().cell_of(i));
    const bool border = at.minCoeff() < 0.1 || at.x() > 23.9 || at.y() > 11.9;
    if (border || is_wall(at)) occupancy[i] = 1.0f;
  }
  PlanProblem problem{OccupancyMap(std::move(occupancy)), test::heading_map({.resolution = 1.0, .width = 24, .height = 12}, 8, alpha), {}};
  problem.query.robot.radius = 0.4;
  problem.query.start = {2.0, 6.0, 0.0};
  problem.query.goal = {22.0, 6.0, 0.0};
  problem.query.goal_tolerance = {.position = 0.3, .heading = radians(20)};
  problem.query.planner = {.name = "", .time = 30.0 * test::kPatience, .iterations = std::nullopt, .seed = 1};
  return problem;
}

bool nowhere(const Eigen::Vector2d&) { return false; }

// Between a corridor that is rich for whoever looks east and one for whoever looks west.
bool between_corridors(const Eigen::Vector2d& at) { return at.x() > 4.0 && at.x() < 20.0 && at.y() > 4.0 && at.y() < 8.0; }
float by_corridor(const Eigen::Vector2d& at, double yaw) {
  if (at.x() < 3.0 || at.x() > 21.0) return 0.8f;
  const double towards = at.y() > 6.0 ? std::cos(yaw) : -std::cos(yaw);
  return towards > 0.5 ? 0.6f : 0.02f;
}

PlanProblem one_way_corridors() { return hall(by_corridor, between_corridors); }

double least_y(const PlanResult& result) { return std::ranges::min(result.path, {}, &Pose2::y).y; }
double greatest_y(const PlanResult& result) { return std::ranges::max(result.path, {}, &Pose2::y).y; }

// By steps of some millimetres.
double sampled_cost(const PlanResult& result, const RiskField& risk) {
  double cost = 0.0;
  for (std::size_t i = 1; i < result.path.size(); ++i) {
    const Pose2 &from = result.path[i - 1], &to = result.path[i];
    const double length = (to.position() - from.position()).norm();
    const int steps = 1 + static_cast<int>(length / 0.003);
    for (int k = 0; k < steps; ++k) {
      const Pose2 at = between(from, to, (k + 0.5) / steps);
      cost += length / steps * (1.0 + result.query.weight * risk.risk(at.x, at.y, at.yaw));
    }
    if (result.query.motion.space != MotionSpace::r2) {
      cost += result.query.motion.turn_cost * std::abs(normalized_angle(to.yaw - from.yaw));
    }
  }
  return cost;
}

std::shared_ptr<const RiskField> risk_of(const PlanProblem& problem) { return PlanningFields(problem).risk; }

template <typename Space, typename Bounds>
ob::SpaceInformationPtr space_information(const Bounds& bounds, const std::shared_ptr<Space>& space) {
  space->setBounds(bounds);
  const auto si = std::make_shared<ob::SpaceInformation>(space);
  si->setStateValidityChecker([](const ob::State*) { return true; });
  si->setup();
  return si;
}

ob::SpaceInformationPtr plane() {
  ob::RealVectorBounds bounds(2);
  bounds.setLow(0.0);
  bounds.setHigh(24.0);
  return space_information(bounds, std::make_shared<ob::RealVectorStateSpace>(2));
}

ob::SpaceInformationPtr poses() {
  ob::RealVectorBounds bounds(2);
  bounds.setLow(0.0);
  bounds.setHigh(24.0);
  return space_information(bounds, std::make_shared<ob::SE2StateSpace>());
}

double cost_between(const Pose2& from, const Pose2& to, const ob::SpaceInformationPtr& si, const AlignabilityObjective& objective) {
  ob::ScopedState<> a(si), b(si);
  set_pose(*si->getStateSpace(), from, a.get());
  set_pose(*si->getStateSpace(), to, b.get());
  return objective.motionCost(a.get(), b.get()).value();
}

TEST(ObjectiveByHeading, TakesThePlanesRobotToFaceWhereItGoes) {
  const auto si = plane();
  const AlignabilityObjective objective(si, risk_of(hall(looking_east, nowhere)), {.weight = 5.0});
  EXPECT_NEAR(cost_between({5, 5, 0}, {15, 5, 0}, si, objective), 10.0, 1e-9);
  EXPECT_NEAR(cost_between({15, 5, 0}, {5, 5, 0}, si, objective), 60.0, 1e-9);
  EXPECT_FALSE(objective.isSymmetric());
  ob::ScopedState<> at(si);
  set_pose(*si->getStateSpace(), {5, 5, 0}, at.get());
  EXPECT_NEAR(objective.stateCost(at.get()).value(), 1.0, 1e-9) << "at the best heading";
}

TEST(ObjectiveByHeading, PricesWhatARobotFacesOnItsWay) {
  const auto si = poses();
  const AlignabilityObjective objective(si, risk_of(hall(looking_east, nowhere)), {.weight = 5.0, .turn_cost = 0.2});
  EXPECT_TRUE(objective.isSymmetric());
  EXPECT_NEAR(cost_between({5, 5, 0}, {15, 5, 0}, si, objective), 10.0, 1e-9);
  EXPECT_NEAR(cost_between({15, 5, 0}, {5, 5, 0}, si, objective), 10.0, 1e-9) << "it need not face where it goes";
  EXPECT_NEAR(cost_between({5, 5, kWest}, {15, 5, kWest}, si, objective), 60.0, 1e-9);
  const double turning = cost_between({5, 5, 0}, {15, 5, 3.0}, si, objective);
  EXPECT_GT(turning, 20.0);
  EXPECT_LT(turning, 50.0);
  EXPECT_EQ(turning, cost_between({15, 5, 3.0}, {5, 5, 0}, si, objective));
}

TEST(BoundByHeading, IsBelowWhatAnyHeadingsCost) {
  constexpr std::uint64_t kSeed = 31;
  SCOPED_TRACE(kSeed);
  std::mt19937_64 random(kSeed);
  std::uniform_real_distribution<double> uniform;
  const PlanProblem problem = hall([&](const Eigen::Vector2d&, double) { return static_cast<float>(uniform(random) * 0.6); }, nowhere);
  const PlanningFields fields(problem);
  const auto lattice = std::make_shared<const CostLattice>(*fields.risk, *fields.clearance, 5.0, 0.4);
  const Eigen::Vector2d goal(12.0, 6.0);
  const CostBound bound(lattice, goal, 0.0);
  const auto random_pose = [&] { return Pose2{1.0 + 22.0 * uniform(random), 1.0 + 10.0 * uniform(random), 6.0 * uniform(random)}; };
  for (int i = 0; i < 1000; ++i) {
    const Pose2 from = random_pose(), to = random_pose();
    const double cost = (to.position() - from.position()).norm() + 5.0 * fields.risk->integral(from, to);
    EXPECT_LE(std::abs(bound(from.position()) - bound(to.position())), cost + 1e-6);
    const Arc arc(from, 2.0 * uniform(random) - 1.0, 2.0 * uniform(random) - 1.0);
    if (!fields.clearance->is_clear(arc, 0.4)) continue;
    EXPECT_LE(std::abs(bound(from.position()) - bound(arc.end().position())), arc.length() + 5.0 * fields.risk->integral(arc) + 1e-6);
  }
}

TEST(FieldByHeading, TurnsTheRobotToWhereItIsLocalized) {
  PlanProblem problem = hall(looking_east, nowhere);
  problem.query.start.yaw = kWest;
  problem.query.goal.yaw = kWest;
  const PlanResult result = plan(problem, {});
  ASSERT_EQ(result.status, PlanStatus::solved);
  EXPECT_NEAR(result.cost, sampled_cost(result, *risk_of(problem)), 1e-2);
  EXPECT_LE(*result.lower_bound, result.cost);
  // To turn to the east and back, and on the way the more the sooner.
  EXPECT_LT(result.cost, 20.0 + 0.2 * 2.0 * kWest + 2.0);
  const Pose2 middle = result.path[result.path.size() / 2];
  EXPECT_LT(std::abs(normalized_angle(middle.yaw)), 1.2);
}

TEST(FieldByHeading, InThePlaneTakesAnotherWayThanBack) {
  PlanProblem problem = one_way_corridors();
  problem.query.motion.space = MotionSpace::r2;
  const auto risk = risk_of(problem);
  const PlanResult there = plan(problem, {});
  ASSERT_EQ(there.status, PlanStatus::solved);
  EXPECT_GT(least_y(there), 5.5) << "through the corridor that is rich to the east";
  std::swap(problem.query.start, problem.query.goal);
  const PlanResult back = plan(problem, {});
  ASSERT_EQ(back.status, PlanStatus::solved);
  EXPECT_LT(greatest_y(back), 6.5);
  for (const PlanResult& result : {there, back}) {
    EXPECT_NEAR(result.cost, sampled_cost(result, *risk), 0.01 * result.cost);
    EXPECT_NEAR(result.cost, result.figures.length + result.query.weight * result.figures.risk_integral, 1e-9);
    EXPECT_LE(*result.lower_bound, result.cost);
    EXPECT_LT(result.cost, 27.0);
  }
}

TEST(FieldByHeading, FreeToTurnMayTakeEitherWay) {
  PlanProblem problem = one_way_corridors();
  for (int way = 0; way < 2; ++way) {
    const PlanResult result = plan(problem, {});
    ASSERT_EQ(result.status, PlanStatus::solved);
    EXPECT_NEAR(result.cost, sampled_cost(result, *risk_of(problem)), 0.01 * result.cost);
    EXPECT_LE(*result.lower_bound, result.cost);
    EXPECT_LT(result.cost, 28.0);
    std::swap(problem.query.start, problem.query.goal);
  }
}

TEST(PlannersByHeading, AreNotBetterThanTheBoundSays) {
  for (const MotionSpace space : {MotionSpace::r2, MotionSpace::se2}) {
    PlanProblem problem = one_way_corridors();
    problem.query.motion.space = space;
    const PlanResult field = plan(problem, {});
    ASSERT_EQ(field.status, PlanStatus::solved);
    for (const char* name : {"rrtstar", "bitstar"}) {
      problem.query.planner = {.name = name, .time = 2.0 * test::kPatience, .iterations = std::nullopt, .seed = 1};
      const PlanResult result = plan(problem, {});
      ASSERT_EQ(result.status, PlanStatus::solved) << name;
      EXPECT_LE(*result.lower_bound, result.cost) << name;
      EXPECT_NEAR(result.cost, sampled_cost(result, *risk_of(problem)), 0.01 * result.cost) << name;
      EXPECT_LT(field.cost, 1.05 * result.cost) << name;
    }
  }
}

// An aisle whose east end, a junction, is all that there is to see.
PlanProblem aisle() {
  PlanProblem problem = hall(looking_east, nowhere);
  problem.query.motion = {.space = MotionSpace::reeds_shepp, .turn_cost = 0.2, .turning_radius = 1.5, .reverse_penalty = 1.0};
  problem.query.start = {22.0, 6.0, 0.0};
  problem.query.goal = {2.0, 6.0, 0.0};
  return problem;
}

TEST(CarByHeading, DrivesBackwardWhereThatIsSafer) {
  PlanProblem problem = aisle();
  const PlanResult safe = plan(problem, {});
  problem.query.weight = 0.0;
  const PlanResult shortest = plan(problem, {});
  ASSERT_EQ(safe.status, PlanStatus::solved);
  ASSERT_EQ(shortest.status, PlanStatus::solved);
  EXPECT_GT(safe.figures.backward_length, 19.0);
  EXPECT_NEAR(safe.figures.risk_integral, 0.0, 0.1);
  EXPECT_LT(shortest.figures.backward_length, 8.0) << "it turns around and looks where it goes";
  EXPECT_GT(shortest.figures.risk_integral, 8.0);
  EXPECT_LE(*safe.lower_bound, safe.cost);
}

TEST(CarByHeading, DrivesForwardWhereItsLidarLooksBackward) {
  PlanProblem problem = hall([](const Eigen::Vector2d& at, double yaw) { return looking_east(at, yaw + kWest); }, nowhere);
  problem.query.motion = aisle().query.motion;
  problem.query.start = {22.0, 6.0, 0.0};
  problem.query.goal = {2.0, 6.0, kWest};
  const PlanResult safe = plan(problem, {});
  ASSERT_EQ(safe.status, PlanStatus::solved);
  EXPECT_LT(safe.figures.backward_length, 5.0);
  EXPECT_LT(safe.figures.risk_integral, 5.0);
}

TEST(CarByHeading, KeepsItsLimitsByDrivingBackward) {
  PlanProblem problem = aisle();
  problem.query.start.x = 10.0;
  problem.query.motion.reverse_penalty = 3.0;
  problem.query.weight = 0.0;
  const PlanResult blind = plan(problem, {});
  problem.query.max_blind_distance = 3.0;
  const PlanResult within = plan(problem, {});
  ASSERT_EQ(blind.status, PlanStatus::solved);
  ASSERT_EQ(within.status, PlanStatus::solved);
  EXPECT_GT(blind.figures.longest_blind, 3.0);
  EXPECT_LE(within.figures.longest_blind, 3.0 + 1e-9);
  EXPECT_LE(*within.longest_unrecovered, 3.0 + 1e-9);
}

TEST(CarByHeading, KeepsAFloorByDrivingBackward) {
  PlanProblem problem = aisle();
  problem.query.weight = 0.0;
  problem.query.risk.min_alpha = 0.3;
  const PlanResult result = plan(problem, {});
  ASSERT_EQ(result.status, PlanStatus::solved);
  EXPECT_GT(result.figures.backward_length, 15.0);
  EXPECT_GE(result.figures.alpha_min, 0.3 - 1e-9);
}

TEST(FloorByHeading, IsKeptFacingWhereItMay) {
  PlanProblem problem = hall(looking_east, nowhere);
  problem.query.weight = 0.0;
  problem.query.risk.min_alpha = 0.3;
  std::swap(problem.query.start, problem.query.goal);
  const PlanResult result = plan(problem, {});
  ASSERT_EQ(result.status, PlanStatus::solved);
  EXPECT_GE(result.figures.alpha_min, 0.3 - 1e-9);
  problem.query.motion.space = MotionSpace::r2;
  problem.query.planner.time = 0.5;
  EXPECT_NE(plan(problem, {}).status, PlanStatus::solved) << "where it goes it may not look";
  std::swap(problem.query.start, problem.query.goal);
  EXPECT_EQ(plan(problem, {}).status, PlanStatus::solved);
  problem.query.risk.min_alpha = 0.6;
  EXPECT_EQ(plan(problem, {}).status, PlanStatus::infeasible) << "no heading is so rich";
}

TEST(LimitsByHeading, AreRefusedWhereTheyAreKeptByPlaceAlone) {
  PlanProblem problem = hall(looking_east, nowhere);
  problem.query.max_blind_distance = 3.0;
  EXPECT_THAT([&] { plan(problem, {}); }, testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr(
                                              "a limit of blind metres is kept by heading in dubins and reeds_shepp alone")));
  problem = hall(looking_east, nowhere);
  problem.query.motion.space = MotionSpace::r2;
  problem.query.planner.name = "prmstar";
  EXPECT_THAT([&] { plan(problem, {}); }, testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr("direction of travel")));
}

TEST(StationsByHeading, HaveAnotherWayBackThanThere) {
  PlanProblem problem = one_way_corridors();
  problem.query.motion.space = MotionSpace::r2;
  const std::vector<Station> stations{{"west", problem.query.start}, {"east", problem.query.goal}};
  const auto plans = plan_between(stations, problem.query, PlanningFields(problem), {});
  ASSERT_EQ(plans[0][1].status, PlanStatus::solved);
  ASSERT_EQ(plans[1][0].status, PlanStatus::solved);
  EXPECT_GT(least_y(plans[0][1]), 5.5);
  EXPECT_LT(greatest_y(plans[1][0]), 6.5);
}

TEST(EvaluationByHeading, ScoresARouteAsItFaces) {
  const PlanProblem problem = hall(looking_east, nowhere);
  const PlanningFields fields(problem);
  Route route;
  route.path = {{5.0, 6.0, 0.0}, {15.0, 6.0, 0.0}};
  const PathFigures there = evaluate(route, problem.query, fields).total.figures;
  route.path = {{15.0, 6.0, kWest}, {5.0, 6.0, kWest}};
  const PathFigures back = evaluate(route, problem.query, fields).total.figures;
  EXPECT_NEAR(there.risk_integral, 0.0, 1e-9);
  EXPECT_NEAR(there.alpha_mean, 0.5, 1e-6);
  EXPECT_NEAR(back.risk_integral, 10.0, 1e-9);
  EXPECT_NEAR(back.blind_length, 10.0, 1e-9);
  EXPECT_NEAR(back.alpha_min, 0.0, 1e-6);
}

TEST(FiguresByHeading, AreThoseOfLookingEveryMillimetre) {
  constexpr std::uint64_t kSeed = 32;
  SCOPED_TRACE(kSeed);
  std::mt19937_64 random(kSeed);
  std::uniform_real_distribution<double> uniform;
  const PlanProblem problem = hall([&](const Eigen::Vector2d&, double) { return static_cast<float>(0.4 * uniform(random)); }, nowhere);
  const auto risk = risk_of(problem);
  for (int i = 0; i < 20; ++i) {
    const Pose2 from{24.0 * uniform(random), 12.0 * uniform(random), 6.0 * uniform(random)};
    const Pose2 to{24.0 * uniform(random), 12.0 * uniform(random), 6.0 * uniform(random)};
    Curve curve(from);
    curve.append(uniform(random) - 0.5, 6.0 * uniform(random) - 3.0);
    curve.append(0.0, -2.0 * uniform(random));
    const auto expect = [&](const PathFigures& figures, const std::function<Pose2(double)>& at, double length) {
      const int steps = static_cast<int>(length / 0.001) + 1;
      double blind = 0.0, mean = 0.0, least = 1.0;
      for (int k = 0; k < steps; ++k) {
        const Pose2 pose = at((k + 0.5) / steps);
        const double alpha = risk->alpha(pose.x, pose.y, pose.yaw);
        blind += risk->is_blind(alpha) ? length / steps : 0.0;
        mean += alpha / steps;
        least = std::min(least, alpha);
      }
      EXPECT_NEAR(figures.blind_length, blind, 0.01);
      EXPECT_NEAR(figures.alpha_mean, mean, 1e-4);
      EXPECT_NEAR(figures.alpha_min, least, 1e-3);
    };
    expect(
        measure(std::vector{from, to}, *risk), [&](double share) { return between(from, to, share); },
        (to.position() - from.position()).norm());
    expect(
        measure(std::vector{curve}, *risk), [&](double share) { return curve.at(share * curve.length()); }, curve.length());
  }
}

}  // namespace
}  // namespace alignability
