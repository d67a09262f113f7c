// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "core/progress.hpp"
#include "planner/alignability_objective.hpp"
#include "planner/drivable_area.hpp"
#include "planner/plan.hpp"

namespace alignability {

/// Why a query's `max_error` or `max_blind_distance` cannot be kept whatever the path; nullopt when it may be, and where there is none.
std::optional<std::string> refusal_of_limit(const PlanQuery& query, const std::optional<ErrorModel>& model);

/// Why a query cannot be planned where risk depends on heading: limits of the way in R² and SE(2), which are kept by place alone, and
/// in R² planners that take the way back for as dear as the way there; nullopt when it can.
std::optional<std::string> refusal_by_headings(const PlanQuery& query, const RiskField& risk);

/// A solved plan with the error that a model predicts on its path, and how blind it gets; where that exceeds the query's limits, with
/// another path that keeps them: in R² and SE(2) one along which a disk turns evenly, for a car one of the objective's curves. Infeasible
/// where none is found. Throws Interrupted.
PlanResult within_limit(PlanResult result, const std::optional<ErrorModel>& model, const DrivableArea& area,
                        const AlignabilityObjective& objective, const StopTest& stop);

}  // namespace alignability
