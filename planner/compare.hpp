// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planner/plan.hpp"

namespace alignability {

/// The same query planned for length alone and for the risk too. Both paths' figures are taken in the same risk field.
struct Comparison {
  PlanResult shortest;    ///< w = 0
  PlanResult risk_aware;  ///< w as asked
};

/// Whether both were.
bool solved(const Comparison& comparison);

/// Plans both, each with the planner and the bound of the query. Throws as plan does.
Comparison compare(const PlanQuery& query, const PlanningFields& fields, const PlanOptions& options);
Comparison compare(const PlanProblem& problem, const PlanOptions& options);

}  // namespace alignability
