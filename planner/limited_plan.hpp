// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <stop_token>
#include <string>

#include "planner/drivable_area.hpp"
#include "planner/plan.hpp"

namespace alignability {

/// Why a query's `max_error` cannot be kept whatever the path; nullopt when it may be, and where there is none.
std::optional<std::string> refusal_of_limit(const PlanQuery& query, const std::optional<ErrorModel>& model);

/// A solved plan with the error that a model predicts on its path; where that exceeds the query's `max_error`, with another path that keeps
/// it, or, where none is found, infeasible. Stopped, it may say so too early.
PlanResult within_limit(PlanResult result, const ErrorModel& model, const DrivableArea& area, const std::stop_token& stop);

}  // namespace alignability
