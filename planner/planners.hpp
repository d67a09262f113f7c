// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ompl/base/Planner.h>

#include <optional>
#include <string>
#include <vector>

#include "planner/plan_problem.hpp"

namespace alignability {

/// The one that is nearest to the optimum soonest: docs/planners.md has the figures.
inline constexpr const char* kDefaultPlanner = "field";

/// The names of the planners that are offered, our own first, each honouring the objective.
std::vector<std::string> planner_names();

/// Why a planner of that name is not offered; nullopt when it is.
std::optional<std::string> refusal_of_planner(const std::string& name);
/// Likewise in a space, where one that is offered elsewhere may not be.
std::optional<std::string> refusal_of_planner(const std::string& name, MotionSpace space);

/// The planner of that choice, its settings those that a cost map allows: no pruning and no rejection by straight-line cost-to-come.
/// Throws std::invalid_argument with the refusal.
ompl::base::PlannerPtr make_planner(const PlannerChoice& choice, const ompl::base::SpaceInformationPtr& si);

/// Whether a planner draws as many samples as there are iterations and then stops by itself, so that nobody else is to count.
bool counts_its_own_iterations(const std::string& name);

/// Whether a planner draws from the objective's informed set, and so is the better for bounds.
bool gains_from_bounds(const std::string& name);

/// Whether a planner tells of its first solution when it has it; CForest does not.
bool reports_its_first_solution(const std::string& name);

}  // namespace alignability
