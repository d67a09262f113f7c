// SPDX-License-Identifier: BSD-3-Clause
// planted_race build|objective [guarded]: what a careless hand might write, and the same with an atomic.
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/cforest/CForest.h>

#include <atomic>
#include <cstddef>
#include <iostream>
#include <string_view>

#include "lidar/in_parallel.hpp"
#include "planner/alignability_objective.hpp"
#include "planner/drivability.hpp"
#include "planner/plan.hpp"
#include "tests/planner/two_corridors.hpp"

namespace alignability {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

template <typename Counter>
void count_planted_cells() {
  Counter counted{0};
  in_parallel(1000, 2, [&](std::size_t) {
    // Long enough for both threads to take part.
    for (volatile int wait = 0; wait < 10000;) wait = wait + 1;
    ++counted;
  });
  std::cout << counted << " cells\n";
}

template <typename Counter>
class PlantedObjective : public AlignabilityObjective {
 public:
  using AlignabilityObjective::AlignabilityObjective;

  ob::Cost motionCost(const ob::State* from, const ob::State* to) const override {
    ++asked_;
    return AlignabilityObjective::motionCost(from, to);
  }

 private:
  mutable Counter asked_{0};
};

template <typename Counter>
void plan_by_planted_objective() {
  const PlanProblem problem = test::two_corridors();
  const PlanningFields fields(problem);
  const DrivableArea area{fields.clearance, fields.risk, problem.query.robot};
  const auto space = std::make_shared<ob::RealVectorStateSpace>();
  space->addDimension(0.0, 20.0);
  space->addDimension(0.0, 10.0);
  og::SimpleSetup setup(space);
  const auto& si = setup.getSpaceInformation();
  setup.setStateValidityChecker(std::make_shared<DrivabilityChecker>(si, area));
  si->setMotionValidator(std::make_shared<DrivabilityMotionValidator>(si, area));
  setup.setOptimizationObjective(std::make_shared<PlantedObjective<Counter>>(si, fields.risk, ObjectiveOptions{.weight = 5.0}));
  ob::ScopedState<> start(si), goal(si);
  start = std::vector{2.0, 8.5};
  goal = std::vector{18.0, 8.5};
  setup.setStartAndGoalStates(start, goal, 0.1);
  const auto planner = std::make_shared<og::CForest>(si);
  planner->setNumThreads(2);
  setup.setPlanner(planner);
  setup.solve(2.0);
}

}  // namespace
}  // namespace alignability

int main(int count, char** words) {
  using namespace alignability;
  const std::string_view place = count > 1 ? words[1] : "";
  const bool guarded = count > 2 && words[2] == std::string_view("guarded");
  if (place == "build") guarded ? count_planted_cells<std::atomic<int>>() : count_planted_cells<int>();
  if (place == "objective") guarded ? plan_by_planted_objective<std::atomic<int>>() : plan_by_planted_objective<int>();
  return 0;
}
