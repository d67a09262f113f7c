// SPDX-License-Identifier: BSD-3-Clause
// Certified bounds for whole routes, and samples of where a better path may pass.
#include <gtest/gtest.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/terminationconditions/IterationTerminationCondition.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>

#include "planner/alignability_objective.hpp"
#include "planner/drivability.hpp"
#include "planner/informed_field_sampler.hpp"
#include "planner/plan.hpp"
#include "planner/poses.hpp"
#include "tests/planner/random_sites.hpp"
#include "tests/planner/two_corridors.hpp"

namespace alignability {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

constexpr double kWeight = 5.0;

class InformedSet : public testing::TestWithParam<bool> {
 protected:
  InformedSet() : setup(space()) {
    const ob::SpaceInformationPtr& si = setup.getSpaceInformation();
    setup.setStateValidityChecker(std::make_shared<DrivabilityChecker>(si, area));
    si->setMotionValidator(std::make_shared<DrivabilityMotionValidator>(si, area));
    objective = std::make_shared<AlignabilityObjective>(si, fields.risk, ObjectiveOptions{.weight = kWeight});
    objective->set_bounds(bounds);
    setup.setOptimizationObjective(objective);
    ob::ScopedState<> start(si);
    set_pose(*si->getStateSpace(), problem.query.start, start.get());
    setup.setStartState(start);
    setup.setGoal(std::make_shared<PoseGoal>(si, problem.query.goal, problem.query.goal_tolerance));
    setup.getSpaceInformation()->setup();
  }

  static ob::StateSpacePtr space() {
    ob::RealVectorBounds plane(2);
    plane.setLow(0.0);
    plane.setHigh(0, 20.0);
    plane.setHigh(1, 10.0);
    if (GetParam()) {
      const auto se2 = std::make_shared<ob::SE2StateSpace>();
      se2->setBounds(plane);
      return se2;
    }
    const auto r2 = std::make_shared<ob::RealVectorStateSpace>(2);
    r2->setBounds(plane);
    return r2;
  }

  std::shared_ptr<ob::InformedSampler> sampler() const { return objective->allocInformedStateSampler(setup.getProblemDefinition(), 1000); }

  PlanProblem problem = test::two_corridors();
  PlanningFields fields{problem};
  DrivableArea area{fields.clearance, fields.risk, problem.query.robot};
  std::shared_ptr<const RouteBounds> bounds = std::make_shared<const RouteBounds>(
      area, kWeight, problem.query.start.position(), problem.query.goal.position(), problem.query.goal_tolerance.position);
  og::SimpleSetup setup;
  std::shared_ptr<AlignabilityObjective> objective;
};

TEST_P(InformedSet, HoldsEverySampleAndIsDrawnFromEvenly) {
  const auto drawn = sampler();
  ASSERT_NE(dynamic_cast<const InformedFieldSampler*>(drawn.get()), nullptr);
  const double below = 1.1 * bounds->to_goal(problem.query.start.position());
  constexpr int kSamples = 20000;
  ob::ScopedState<> state(setup.getStateSpace());
  int left = 0;
  for (int i = 0; i < kSamples; ++i) {
    ASSERT_TRUE(drawn->sampleUniform(state.get(), ob::Cost(below)));
    const Eigen::Vector2d at = objective->pose_of(state.get()).position();
    ASSERT_LT(bounds->through(at), below);
    ASSERT_FALSE(at.y() > 7.9 && at.x() > 4.0 && at.x() < 16.0) << "in the blind corridor, from which nothing better comes";
    left += at.x() < 8.0 ? 1 : 0;
  }
  // By rejection, with none of the sampler's code.
  std::mt19937_64 engine(3);
  std::uniform_real_distribution<double> x(0.0, 20.0), y(0.0, 10.0);
  int kept = 0, kept_left = 0;
  for (int i = 0; i < 400000; ++i) {
    const Eigen::Vector2d at(x(engine), y(engine));
    if (!(bounds->through(at) < below)) continue;
    ++kept;
    kept_left += at.x() < 8.0 ? 1 : 0;
  }
  EXPECT_NEAR(static_cast<double>(left) / kSamples, static_cast<double>(kept_left) / kept, 0.02);
  const double plane = 200.0 * kept / 400000 * (GetParam() ? 2.0 * std::numbers::pi : 1.0);
  EXPECT_GE(drawn->getInformedMeasure(ob::Cost(below)), 0.98 * plane);
  EXPECT_LE(drawn->getInformedMeasure(ob::Cost(below)), 1.1 * plane);
}

TEST_P(InformedSet, IsEmptyBelowTheBoundAndAllThatCanBeReachedWithoutOne) {
  const auto drawn = sampler();
  ob::ScopedState<> state(setup.getStateSpace());
  EXPECT_FALSE(drawn->sampleUniform(state.get(), ob::Cost(0.9 * bounds->to_goal(problem.query.start.position()))));
  for (int i = 0; i < 1000; ++i) {
    ASSERT_TRUE(drawn->sampleUniform(state.get(), objective->infiniteCost()));
    ASSERT_TRUE(std::isfinite(bounds->through(objective->pose_of(state.get()).position())));
  }
}

TEST_P(InformedSet, HoldsPlacesThatAreBetterThanTheHeuristicOfTheWholeWay) {
  const auto drawn = sampler();
  const ob::State* start = setup.getProblemDefinition()->getStartState(0);
  ob::ScopedState<> goal(setup.getStateSpace()), state(setup.getStateSpace());
  setup.getGoal()->as<ob::GoalSampleableRegion>()->sampleGoal(goal.get());
  // What BIT* asks for as long as it has no path.
  const ob::Cost from = objective->motionCostHeuristic(start, goal.get());
  double least = from.value();
  for (int i = 0; i < 20000; ++i) {
    ASSERT_TRUE(drawn->sampleUniform(state.get(), from, objective->infiniteCost()));
    least = std::min(least, bounds->through(objective->pose_of(state.get()).position()));
  }
  EXPECT_LT(least, from.value());
}

TEST_P(InformedSet, HasAHeuristicAndCostToGoThatAreAdmissibleConsistentAndTighterThanStraightLines) {
  ob::ScopedState<> a(setup.getStateSpace()), b(setup.getStateSpace());
  const ob::Goal* goal = setup.getGoal().get();
  double tightened = 0.0;
  int motions = 0;
  for (int i = 0; i < 20000; ++i) {
    a.random();
    b.random();
    if (!setup.getSpaceInformation()->checkMotion(a.get(), b.get()) || !setup.getSpaceInformation()->isValid(a.get())) continue;
    ++motions;
    const double cost = objective->motionCost(a.get(), b.get()).value();
    const double heuristic = objective->motionCostHeuristic(a.get(), b.get()).value();
    EXPECT_LE(heuristic, cost * (1.0 + 1e-12));
    EXPECT_EQ(heuristic, objective->motionCostHeuristic(b.get(), a.get()).value());
    EXPECT_LE(objective->costToGo(a.get(), goal).value(), heuristic + objective->costToGo(b.get(), goal).value() + 1e-12);
    const double straight = (objective->pose_of(a.get()).position() - objective->pose_of(b.get()).position()).norm();
    tightened += heuristic - straight;
  }
  EXPECT_GT(motions, 1000);
  EXPECT_GT(tightened / motions, 0.5);
}

TEST_P(InformedSet, BringsStockPlannersNearTheOptimum) {
  const double least = bounds->to_goal(problem.query.start.position());
  const ob::SpaceInformationPtr si = setup.getSpaceInformation();
  const auto rrtstar = std::make_shared<og::RRTstar>(si);
  rrtstar->setInformedSampling(true);
  for (const ob::PlannerPtr& planner : {ob::PlannerPtr(std::make_shared<og::BITstar>(si, "kBITstar")), ob::PlannerPtr(rrtstar)}) {
    SCOPED_TRACE(planner->getName());
    setup.setPlanner(planner);
    setup.clear();
    ASSERT_EQ(setup.solve(ob::IterationTerminationCondition(4000)), ob::PlannerStatus::EXACT_SOLUTION);
    const double cost = setup.getSolutionPath().cost(objective).value();
    EXPECT_GE(cost, least);
    EXPECT_LE(cost, 1.25 * least);
  }
}

INSTANTIATE_TEST_SUITE_P(Spaces, InformedSet, testing::Bool(), [](const auto& with_heading) { return with_heading.param ? "se2" : "r2"; });

TEST(RouteBounds, LeaveOutNoPlaceOfAPath) {
  int paths = 0;
  for (std::uint64_t seed = 300; seed < 400; ++seed) {
    SCOPED_TRACE(seed);
    PlanProblem problem = test::random_site(seed);
    problem.query.motion.space = MotionSpace::r2;
    problem.query.planner.name = "field";
    problem.query.planner.iterations = 1000;
    const PlanningFields fields(problem);
    const PlanResult result = plan(problem.query, fields, {});
    if (result.status != PlanStatus::solved) continue;
    ++paths;
    const RouteBounds bounds(DrivableArea(fields.clearance, fields.risk, problem.query.robot), problem.query.weight,
                             problem.query.start.position(), problem.query.goal.position(), problem.query.goal_tolerance.position);
    const std::size_t cells = bounds.cells_below(result.cost * (1.0 + 1e-9));
    for (const PathSample& at : sample(result.path, *fields.risk, 0.05)) {
      const Eigen::Vector2d place = at.pose.position();
      EXPECT_LE(bounds.through(place), result.cost * (1.0 + 1e-9));
      bool held = false;
      for (std::size_t rank = 0; rank < cells && !held; ++rank) held = bounds.cell(rank).exteriorDistance(place) < 1e-9;
      EXPECT_TRUE(held);
    }
  }
  EXPECT_GT(paths, 50);
}

}  // namespace
}  // namespace alignability
