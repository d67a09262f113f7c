// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/util/Exception.h>

#include <cmath>
#include <random>

#include "planner/alignability_objective.hpp"
#include "planner/pose_goal.hpp"
#include "planner/poses.hpp"

namespace alignability {
namespace {

namespace ob = ompl::base;

constexpr double kSide = 12.0;

std::shared_ptr<const RiskField> random_field(std::uint64_t seed, double resolution, const RiskOptions& options = {}) {
  std::mt19937_64 engine(seed);
  std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
  const int cells = static_cast<int>(kSide / resolution);
  Grid<float> alpha({.resolution = resolution, .origin = {0.0, 0.0}, .width = cells, .height = cells}, 0.0f);
  for (std::size_t i = 0; i < alpha.values().size(); ++i) alpha[i] = uniform(engine);
  const OccupancyMap occupancy(Grid<float>(alpha.geometry(), 0.0f));
  AlignabilityMap map;
  map.geometry = alpha.geometry();
  map.layers.push_back({"alpha", std::move(alpha)});
  return std::make_shared<const RiskField>(map, occupancy, options);
}

// With a raster on another grid that counts more than α.
std::shared_ptr<const RiskField> random_field_of_two_risks(std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
  Grid<float> traffic({.resolution = 0.43, .origin = {-0.2, -0.3}, .width = 29, .height = 29}, 0.0f);
  for (std::size_t i = 0; i < traffic.values().size(); ++i) traffic[i] = uniform(engine);
  const RiskSource source{.name = "traffic", .weight = 1.7, .values = std::make_shared<const Grid<float>>(traffic)};
  return random_field(seed, 1.0, {.alpha_weight = 0.6, .sources = {source}});
}

template <typename Space>
ob::SpaceInformationPtr information_of(std::shared_ptr<Space> space) {
  ob::RealVectorBounds bounds(2);
  bounds.setLow(0.0);
  bounds.setHigh(kSide);
  space->setBounds(bounds);
  auto si = std::make_shared<ob::SpaceInformation>(space);
  si->setStateValidityChecker([](const ob::State*) { return true; });
  si->setup();
  return si;
}

struct Setting {
  std::string name;
  ob::SpaceInformationPtr si;
  std::shared_ptr<const RiskField> risk;
};

std::vector<Setting> settings() {
  const auto plane = information_of(std::make_shared<ob::RealVectorStateSpace>(2));
  const auto poses = information_of(std::make_shared<ob::SE2StateSpace>());
  return {{"r2", plane, random_field(3, 1.0)},
          {"se2", poses, random_field(3, 1.0)},
          {"r2_two_risks", plane, random_field_of_two_risks(3)},
          {"se2_two_risks", poses, random_field_of_two_risks(3)}};
}

class Objective : public testing::TestWithParam<std::size_t> {
 protected:
  ob::SpaceInformationPtr si = settings()[GetParam()].si;
  std::shared_ptr<const RiskField> risk = settings()[GetParam()].risk;
  AlignabilityObjective objective{si, risk, {.weight = 4.0, .turn_cost = 0.2}};

  double cost(const ob::ScopedState<>& a, const ob::ScopedState<>& b) const { return objective.motionCost(a.get(), b.get()).value(); }
  double heuristic(const ob::ScopedState<>& a, const ob::ScopedState<>& b) const {
    return objective.motionCostHeuristic(a.get(), b.get()).value();
  }
};

TEST_P(Objective, CostsAtLeastTheLengthAndTheHeuristicIsAtMostTheCost) {
  ob::ScopedState<> a(si), b(si);
  for (int i = 0; i < 500; ++i) {
    a.random();
    b.random();
    const double length = (objective.pose_of(a.get()).position() - objective.pose_of(b.get()).position()).norm();
    EXPECT_GE(cost(a, b), length);
    EXPECT_GE(heuristic(a, b), length);
    EXPECT_LE(heuristic(a, b), cost(a, b));
    EXPECT_TRUE(std::isfinite(objective.stateCost(a.get()).value()));
    EXPECT_GE(objective.stateCost(a.get()).value(), 1.0);
  }
}

TEST_P(Objective, IsAdditiveUnderSplitting) {
  ob::ScopedState<> a(si), b(si), between(si);
  std::mt19937_64 engine(11);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int i = 0; i < 500; ++i) {
    a.random();
    b.random();
    si->getStateSpace()->interpolate(a.get(), b.get(), uniform(engine), between.get());
    EXPECT_NEAR(cost(a, between) + cost(between, b), cost(a, b), 1e-9 * cost(a, b));
  }
}

TEST_P(Objective, IsSymmetricToTheBit) {
  EXPECT_TRUE(objective.isSymmetric());
  ob::ScopedState<> a(si), b(si);
  for (int i = 0; i < 500; ++i) {
    a.random();
    b.random();
    EXPECT_EQ(cost(a, b), cost(b, a));
    EXPECT_EQ(heuristic(a, b), heuristic(b, a));
  }
}

TEST_P(Objective, HasAConsistentHeuristicAndCostToGo) {
  const auto goal = std::make_shared<PoseGoal>(si, Pose2{6.0, 6.0, 0.5}, GoalTolerance{.position = 0.5, .heading = 0.2});
  ASSERT_TRUE(objective.hasCostToGoHeuristic());
  ob::ScopedState<> a(si), b(si), at_goal(si);
  goal->sampleGoal(at_goal.get());
  EXPECT_TRUE(goal->isSatisfied(at_goal.get()));
  EXPECT_EQ(objective.costToGo(at_goal.get(), goal.get()).value(), 0.0);
  for (int i = 0; i < 500; ++i) {
    a.random();
    b.random();
    const double to_go_a = objective.costToGo(a.get(), goal.get()).value();
    const double to_go_b = objective.costToGo(b.get(), goal.get()).value();
    EXPECT_LE(to_go_a, cost(a, b) + to_go_b + 1e-12);
    EXPECT_LE(to_go_a, heuristic(a, b) + to_go_b + 1e-12);
    EXPECT_TRUE(to_go_a == 0.0 || !goal->isSatisfied(a.get()));
  }
}

INSTANTIATE_TEST_SUITE_P(Spaces, Objective, testing::Range<std::size_t>(0, 4),
                         [](const auto& setting) { return settings()[setting.param].name; });

TEST(AlignabilityObjective, ChargesAStripFiveCentimetresWideAcrossALongEdge) {
  // α-cells of 2.5 cm; one column of them is risky, which makes a tent 5 cm wide of area 2.5 cm.
  Grid<float> alpha({.resolution = 0.025, .origin = {0.0, 0.0}, .width = 2000, .height = 4}, 1.0f);
  for (int y = 0; y < 4; ++y) alpha[Cell{1234, y}] = 0.0f;
  const OccupancyMap occupancy(Grid<float>(alpha.geometry(), 0.0f));
  AlignabilityMap map;
  map.geometry = alpha.geometry();
  map.layers.push_back({"alpha", std::move(alpha)});
  const auto risk = std::make_shared<const RiskField>(map, occupancy, RiskOptions{});
  auto space = std::make_shared<ob::RealVectorStateSpace>(2);
  const auto si = information_of(space);
  const AlignabilityObjective objective(si, risk, {.weight = 5.0});
  ob::ScopedState<ob::RealVectorStateSpace> a(space), b(space);
  a->values[0] = 0.5;
  a->values[1] = 0.05;
  b->values[0] = 49.5;
  b->values[1] = 0.05;
  EXPECT_NEAR(objective.motionCost(a.get(), b.get()).value(), 49.0 + 5.0 * 0.025, 1e-9);
}

TEST(AlignabilityObjective, ChargesForTurningOnTheSpotInSe2) {
  const auto si = information_of(std::make_shared<ob::SE2StateSpace>());
  const AlignabilityObjective objective(si, random_field(1, 1.0), {.weight = 5.0, .turn_cost = 0.3});
  ob::ScopedState<> a(si), b(si);
  set_pose(*si->getStateSpace(), {5.0, 5.0, 3.0}, a.get());
  set_pose(*si->getStateSpace(), {5.0, 5.0, -3.0}, b.get());
  EXPECT_NEAR(objective.motionCost(a.get(), b.get()).value(), 0.3 * (2.0 * std::numbers::pi - 6.0), 1e-12);
}

TEST(AlignabilityObjective, ServesAnySpaceByAProjection) {
  const auto space = std::make_shared<ob::ReedsSheppStateSpace>(1.0);
  const auto si = information_of(space);
  const auto risk = random_field(5, 1.0);
  const auto project = [](const ob::State* state) {
    const auto* pose = state->as<ob::SE2StateSpace::StateType>();
    return Pose2{pose->getX(), pose->getY(), pose->getYaw()};
  };
  const AlignabilityObjective objective(si, risk, {.weight = 5.0, .turn_cost = 0.0}, project, MotionShape::interpolated);
  // A chord is shorter than its arc, of radius 1, and a cusp within a step, of which there are two at most, may fold that up.
  const double step = space->getLongestValidSegmentLength();
  const double least_share = std::sin(0.5 * step) / (0.5 * step);
  ob::ScopedState<> a(si), b(si);
  for (int i = 0; i < 50; ++i) {
    a.random();
    b.random();
    EXPECT_GE(objective.motionCost(a.get(), b.get()).value(), least_share * space->distance(a.get(), b.get()) - 2.0 * step);
  }
}

TEST(AlignabilityObjective, RefusesASpaceItKnowsNoProjectionOf) {
  const auto space = std::make_shared<ob::RealVectorStateSpace>(3);
  ob::RealVectorBounds bounds(3);
  bounds.setLow(0.0);
  bounds.setHigh(1.0);
  space->setBounds(bounds);
  const auto si = std::make_shared<ob::SpaceInformation>(space);
  EXPECT_THROW(AlignabilityObjective(si, random_field(1, 1.0), {}), ompl::Exception);
}

TEST(AlignabilityObjective, RefusesANegativeWeight) {
  const auto si = information_of(std::make_shared<ob::SE2StateSpace>());
  EXPECT_THROW(AlignabilityObjective(si, random_field(1, 1.0), {.weight = -1.0}), ompl::Exception);
  EXPECT_THROW(AlignabilityObjective(si, random_field(1, 1.0), {.weight = std::nan("")}), ompl::Exception);
}

}  // namespace
}  // namespace alignability
