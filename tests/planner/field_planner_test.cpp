// SPDX-License-Identifier: BSD-3-Clause
#include "planner/field_planner.hpp"

#include <gtest/gtest.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/util/Exception.h>

#include "planner/alignability_objective.hpp"
#include "planner/drivability.hpp"
#include "planner/plan.hpp"
#include "tests/planner/collision_oracle.hpp"
#include "tests/planner/patience.hpp"
#include "tests/planner/random_sites.hpp"
#include "tests/planner/two_corridors.hpp"

namespace alignability {
namespace {

namespace ob = ompl::base;

TEST(FieldPlanner, SolvesAThousandRandomSitesAboveTheBoundAndWithoutCollision) {
  int solved = 0;
  double worst = 1.0;
  for (std::uint64_t seed = 1; seed <= 1000 / test::kOneOf; ++seed) {
    SCOPED_TRACE(seed);
    PlanProblem problem = test::random_site(seed);
    problem.query.motion.space = seed % 2 == 0 ? MotionSpace::r2 : MotionSpace::se2;
    problem.query.planner = {.name = "field", .time = 1.0, .iterations = 2000, .seed = 1};
    const PlanResult result = plan(problem, {});
    if (result.status == PlanStatus::no_path) continue;
    if (result.status != PlanStatus::solved) {
      EXPECT_EQ(result.status, PlanStatus::timeout);
      continue;
    }
    ++solved;
    ASSERT_TRUE(result.lower_bound.has_value());
    EXPECT_GE(result.cost, *result.lower_bound * (1.0 - 1e-12));
    EXPECT_FALSE(test::first_collision(problem.occupancy, problem.query.robot, result.path).has_value());
    const double turned = problem.query.motion.space == MotionSpace::se2 ? problem.query.motion.turn_cost * result.figures.turned : 0.0;
    EXPECT_NEAR(result.cost, result.figures.length + problem.query.weight * result.figures.risk_integral + turned,
                1e-9 * result.cost + 1e-12);
    if (result.cost > 3.0) worst = std::max(worst, result.cost / *result.lower_bound);
  }
  EXPECT_GT(solved, 600 / test::kOneOf);
  RecordProperty("solved", solved);
  RecordProperty("worst_gap", std::to_string(worst));
}

TEST(FieldPlanner, RepeatsItsPathUnderATimeToo) {
  PlanProblem problem = test::two_corridors();
  problem.query.planner.name = "field";
  const PlanResult first = plan(problem, {});
  ASSERT_EQ(first.status, PlanStatus::solved);
  EXPECT_EQ(first.path, plan(problem, {}).path);
}

// What a stranger's program has, without plan().
class FieldPlannerEmbedded : public testing::Test {
 protected:
  FieldPlannerEmbedded() : setup(plane()) {
    const auto& si = setup.getSpaceInformation();
    setup.setStateValidityChecker(std::make_shared<DrivabilityChecker>(si, area));
    si->setMotionValidator(std::make_shared<DrivabilityMotionValidator>(si, area));
    setup.setOptimizationObjective(std::make_shared<AlignabilityObjective>(si, fields.risk, ObjectiveOptions{.weight = 5.0}));
    ob::ScopedState<> start(si), goal(si);
    start = std::vector{2.0, 8.5};
    goal = std::vector{18.0, 8.5};
    setup.setStartAndGoalStates(start, goal, 0.1);
    setup.setPlanner(std::make_shared<FieldPlanner>(si));
  }

  static ob::StateSpacePtr plane() {
    const auto space = std::make_shared<ob::RealVectorStateSpace>();
    space->addDimension(0.0, 20.0);
    space->addDimension(0.0, 10.0);
    return space;
  }

  PlanProblem problem = test::two_corridors();
  PlanningFields fields{problem};
  DrivableArea area{fields.clearance, fields.risk, problem.query.robot};
  ompl::geometric::SimpleSetup setup;
};

TEST_F(FieldPlannerEmbedded, SolvesASimpleSetupAndTellsOfItsPath) {
  int told = 0;
  setup.getProblemDefinition()->setIntermediateSolutionCallback(
      [&](const ob::Planner*, const std::vector<const ob::State*>& states, const ob::Cost cost) {
        ++told;
        EXPECT_GE(states.size(), 2u);
        EXPECT_GT(cost.value(), 20.0);
      });
  EXPECT_EQ(setup.solve(10.0), ob::PlannerStatus::EXACT_SOLUTION);
  EXPECT_EQ(told, 1);
  EXPECT_TRUE(setup.getSolutionPath().check());
  ob::PlannerData data(setup.getSpaceInformation());
  setup.getPlannerData(data);
  EXPECT_EQ(data.numVertices(), setup.getSolutionPath().getStateCount());
  EXPECT_EQ(data.numStartVertices(), 1u);
  EXPECT_EQ(data.numGoalVertices(), 1u);
}

TEST_F(FieldPlannerEmbedded, SolvesAgainWithAndWithoutClearing) {
  ASSERT_EQ(setup.solve(10.0), ob::PlannerStatus::EXACT_SOLUTION);
  const double cost = setup.getSolutionPath().cost(setup.getOptimizationObjective()).value();
  EXPECT_EQ(setup.solve(10.0), ob::PlannerStatus::EXACT_SOLUTION);
  setup.clear();
  EXPECT_FALSE(setup.haveSolutionPath());
  EXPECT_EQ(setup.solve(10.0), ob::PlannerStatus::EXACT_SOLUTION);
  EXPECT_EQ(setup.getSolutionPath().cost(setup.getOptimizationObjective()).value(), cost);
}

TEST_F(FieldPlannerEmbedded, GivesUpWhenItMayNotEvenBegin) {
  EXPECT_EQ(setup.solve(ob::plannerAlwaysTerminatingCondition()), ob::PlannerStatus::TIMEOUT);
}

TEST_F(FieldPlannerEmbedded, NeedsTheProjectsCheckerAndObjective) {
  setup.setOptimizationObjective(std::make_shared<ob::PathLengthOptimizationObjective>(setup.getSpaceInformation()));
  EXPECT_THROW(setup.setup(), ompl::Exception);
}

}  // namespace
}  // namespace alignability
