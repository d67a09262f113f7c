// SPDX-License-Identifier: BSD-3-Clause
#include "planner/compare.hpp"

namespace alignability {

Comparison compare(const PlanProblem& problem, const PlanOptions& options) {
  PlanProblem shortest = problem;
  shortest.query.weight = 0.0;
  return {plan(shortest, options), plan(problem, options)};
}

}  // namespace alignability
