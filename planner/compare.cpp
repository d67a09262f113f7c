// SPDX-License-Identifier: BSD-3-Clause
#include "planner/compare.hpp"

#include <array>
#include <utility>

#include "planner/trade_off.hpp"

namespace alignability {

bool solved(const Comparison& comparison) {
  return comparison.shortest.status == PlanStatus::solved && comparison.risk_aware.status == PlanStatus::solved;
}

double length_ratio(const Comparison& comparison) {
  const double shortest = comparison.shortest.figures.length;
  return shortest > 0.0 ? comparison.risk_aware.figures.length / shortest : 1.0;
}

Comparison compare(const PlanQuery& query, const PlanningFields& fields, const PlanOptions& options) {
  const std::array weights{0.0, query.weight};
  std::vector<PlanResult> plans = trade_off(query, fields, weights, options);
  return {std::move(plans.front()), std::move(plans.back())};
}

Comparison compare(const PlanProblem& problem, const PlanOptions& options) {
  return compare(problem.query, PlanningFields(problem), options);
}

}  // namespace alignability
