// SPDX-License-Identifier: BSD-3-Clause
// What a stranger's program does with the parts, without plan(): OMPL's own tools drive them.
#include <gtest/gtest.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/AnytimePathShortening.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/tools/benchmark/Benchmark.h>

#include "planner/alignability_objective.hpp"
#include "planner/drivability.hpp"
#include "planner/field_planner.hpp"
#include "planner/plan.hpp"
#include "tests/planner/collision_oracle.hpp"
#include "tests/planner/patience.hpp"
#include "tests/planner/two_corridors.hpp"

namespace alignability {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

class Embedded : public testing::Test {
 protected:
  Embedded() : setup(plane()) {
    const auto& si = setup.getSpaceInformation();
    setup.setStateValidityChecker(std::make_shared<DrivabilityChecker>(si, area));
    si->setMotionValidator(std::make_shared<DrivabilityMotionValidator>(si, area));
    const auto objective = std::make_shared<AlignabilityObjective>(si, fields.risk, ObjectiveOptions{.weight = kWeight});
    objective->set_bounds(std::make_shared<const RouteBounds>(area, kWeight, Eigen::Vector2d(2.0, 8.5), Eigen::Vector2d(18.0, 8.5), 0.1));
    setup.setOptimizationObjective(objective);
    ob::ScopedState<> start(si), goal(si);
    start = std::vector{2.0, 8.5};
    goal = std::vector{18.0, 8.5};
    setup.setStartAndGoalStates(start, goal, 0.1);
  }

  static ob::StateSpacePtr plane() {
    const auto space = std::make_shared<ob::RealVectorStateSpace>();
    space->addDimension(0.0, 20.0);
    space->addDimension(0.0, 10.0);
    return space;
  }

  // By a midpoint sum, with none of the exact integral's code.
  double cost_of(const og::PathGeometric& path) const {
    constexpr int kSteps = 20000;
    const std::vector<Pose2> poses = poses_of(path);
    double cost = 0.0;
    for (std::size_t i = 1; i < poses.size(); ++i) {
      const Pose2& a = poses[i - 1];
      const Pose2& b = poses[i];
      for (int k = 0; k < kSteps; ++k) {
        const Pose2 at = between(a, b, (k + 0.5) / kSteps);
        cost += (1.0 + kWeight * fields.risk->risk(at.x, at.y, 0.0)) * (b.position() - a.position()).norm() / kSteps;
      }
    }
    return cost;
  }

  std::vector<Pose2> poses_of(const og::PathGeometric& path) const {
    std::vector<Pose2> poses;
    for (unsigned int i = 0; i < path.getStateCount(); ++i) {
      const double* at = path.getState(i)->as<ob::RealVectorStateSpace::StateType>()->values;
      poses.push_back({at[0], at[1], 0.0});
    }
    return poses;
  }

  static constexpr double kWeight = 5.0;

  PlanProblem problem = test::two_corridors();
  PlanningFields fields{problem};
  DrivableArea area{fields.clearance, fields.risk, problem.query.robot};
  og::SimpleSetup setup;
};

TEST_F(Embedded, ServesBenchmarksOfManyPlanners) {
  const auto& si = setup.getSpaceInformation();
  ompl::tools::Benchmark benchmark(setup, "two corridors");
  benchmark.addPlanner(std::make_shared<FieldPlanner>(si));
  benchmark.addPlanner(std::make_shared<og::RRTstar>(si));
  // Not BIT*, whose progress OMPL's Benchmark reads from a thread of its own while BIT* changes it: a crash now and then.
  benchmark.addPlanner(std::make_shared<og::RRTConnect>(si));
  ompl::tools::Benchmark::Request request(0.5 * test::kPatience, 4096.0, 2);
  request.displayProgress = false;
  request.saveConsoleOutput = false;
  benchmark.benchmark(request);
  const auto& planners = benchmark.getRecordedExperimentData().planners;
  ASSERT_EQ(planners.size(), 3u);
  for (const auto& planner : planners) {
    SCOPED_TRACE(planner.name);
    ASSERT_EQ(planner.runs.size(), 2u);
    for (const auto& run : planner.runs) {
      EXPECT_EQ(run.at("correct solution BOOLEAN"), "1");
      EXPECT_EQ(run.at("approximate solution BOOLEAN"), "0");
    }
  }
}

TEST_F(Embedded, ServesAnytimePathShorteningWhosePathIsValidAndCostsWhatItSays) {
  const auto& si = setup.getSpaceInformation();
  const auto shortening = std::make_shared<og::AnytimePathShortening>(si);
  for (int i = 0; i < 2; ++i) {
    ob::PlannerPtr planner = std::make_shared<og::RRTstar>(si);
    shortening->addPlanner(planner);
    planner = std::make_shared<og::RRTConnect>(si);
    shortening->addPlanner(planner);
  }
  setup.setPlanner(shortening);
  ASSERT_EQ(setup.solve(1.0 * test::kPatience), ob::PlannerStatus::EXACT_SOLUTION);
  og::PathGeometric path = setup.getSolutionPath();
  EXPECT_TRUE(path.check());
  EXPECT_FALSE(test::first_collision(problem.occupancy, problem.query.robot, poses_of(path)).has_value());
  const double cost = path.cost(setup.getOptimizationObjective()).value();
  EXPECT_NEAR(cost, cost_of(path), 1e-5 * cost);
  const auto& bounds = *static_cast<const AlignabilityObjective&>(*setup.getOptimizationObjective()).bounds();
  EXPECT_GE(cost, bounds.to_goal({2.0, 8.5}));
}

}  // namespace
}  // namespace alignability
