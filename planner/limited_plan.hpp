// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <stop_token>
#include <string>

#include "planner/drivable_area.hpp"
#include "planner/plan.hpp"

namespace alignability {

/// Why a query's `max_error` or `max_blind_distance` cannot be kept whatever the path; nullopt when it may be, and where there is none.
std::optional<std::string> refusal_of_limit(const PlanQuery& query, const std::optional<ErrorModel>& model);

/// A solved plan with the error that a model predicts on its path, and how blind it gets; where that exceeds the query's limit, with
/// another path that keeps it, along which a disk turns evenly; infeasible where none is found.
PlanResult within_limit(PlanResult result, const std::optional<ErrorModel>& model, const DrivableArea& area, const std::stop_token& stop);

}  // namespace alignability
