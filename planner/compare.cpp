// SPDX-License-Identifier: BSD-3-Clause
#include "planner/compare.hpp"

namespace alignability {

bool solved(const Comparison& comparison) {
  return comparison.shortest.status == PlanStatus::solved && comparison.risk_aware.status == PlanStatus::solved;
}

Comparison compare(const PlanQuery& query, const PlanningFields& fields, const PlanOptions& options) {
  PlanQuery shortest = query;
  shortest.weight = 0.0;
  return {plan(shortest, fields, options), plan(query, fields, options)};
}

Comparison compare(const PlanProblem& problem, const PlanOptions& options) {
  return compare(problem.query, PlanningFields(problem), options);
}

}  // namespace alignability
