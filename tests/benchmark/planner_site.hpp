// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ompl/geometric/SimpleSetup.h>

#include <string>

#include "planner/alignability_objective.hpp"
#include "planner/drivability.hpp"
#include "planner/plan.hpp"

namespace alignability::benchmark {

/// What a search is made of besides its planner.
enum class Parts {
  stock,             ///< OMPL's discrete motion checks and trapezoid integral, both by steps of a map's cell
  ours,              ///< DrivabilityMotionValidator and AlignabilityObjective
  ours_with_bounds,  ///< and RouteBounds
};

/// A problem with its fields, for either space.
struct Site {
  Site(std::string name, PlanProblem problem, const Motion& motion);

  /// With start, goal, checker and objective; only the planner is missing.
  ompl::geometric::SimpleSetup setup(Parts parts) const;
  std::shared_ptr<const RouteBounds> bounds() const;
  /// Certified [equivalent m], turning included.
  double lower_bound() const;
  /// By the exact integral; infinite for a path that the exact check refuses.
  double true_cost(const ompl::geometric::PathGeometric& path) const;

  std::string name;
  PlanProblem problem;
  PlanningFields fields;
  DrivableArea area;

 private:
  ompl::base::SpaceInformationPtr judge_;
  std::unique_ptr<const AlignabilityObjective> cost_;
};

}  // namespace alignability::benchmark
