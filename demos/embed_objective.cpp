// SPDX-License-Identifier: BSD-3-Clause
// The shortest program that embeds the objective in an OMPL planner. Run it where maps/ is.
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/terminationconditions/IterationTerminationCondition.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>

#include <iostream>

#include "costmap/map_server.hpp"
#include "planner/alignability_objective.hpp"
#include "planner/drivability.hpp"

int main() {
  using namespace alignability;
  ompl::RNG::setSeed(1);
  const std::filesystem::path site = "maps/warehouse";
  const OccupancyMap occupancy = read_occupancy_map(site / "occupancy.yaml");
  const auto risk = std::make_shared<RiskField>(read_alignability_map(site / "alignability.yaml"), occupancy, RiskOptions{});
  const DrivableArea area(std::make_shared<ClearanceMap>(occupancy), risk, Robot{.radius = 0.6});

  const auto plane = std::make_shared<ompl::base::RealVectorStateSpace>();
  plane->addDimension(0.0, 60.0);
  plane->addDimension(0.0, 45.0);
  ompl::geometric::SimpleSetup setup(plane);
  const auto& si = setup.getSpaceInformation();
  setup.setStateValidityChecker(std::make_shared<DrivabilityChecker>(si, area));
  si->setMotionValidator(std::make_shared<DrivabilityMotionValidator>(si, area));
  setup.setOptimizationObjective(std::make_shared<AlignabilityObjective>(si, risk, ObjectiveOptions{.weight = 5.0}));
  setup.setPlanner(std::make_shared<ompl::geometric::RRTstar>(si));

  ompl::base::ScopedState<> start(plane), goal(plane);
  start = std::vector{5.0, 20.0};
  goal = std::vector{55.0, 20.0};
  setup.setStartAndGoalStates(start, goal, 0.1);
  if (setup.solve(ompl::base::IterationTerminationCondition(5000)) != ompl::base::PlannerStatus::EXACT_SOLUTION) return 1;
  const auto& path = setup.getSolutionPath();
  std::cout << path.length() << " m long, cost " << path.cost(setup.getOptimizationObjective()) << '\n';
}
