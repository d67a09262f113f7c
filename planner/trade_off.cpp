// SPDX-License-Identifier: BSD-3-Clause
#include "planner/trade_off.hpp"

#include <algorithm>

namespace alignability {
namespace {

// What a result's path costs under another weight: it is linear in it.
double cost_under(const PlanResult& result, double weight) {
  return result.cost + (weight - result.query.weight) * result.figures.risk_integral;
}

}  // namespace

std::vector<PlanResult> trade_off(const PlanQuery& query, const PlanningFields& fields, std::span<const double> weights,
                                  const PlanOptions& options) {
  std::vector<PlanResult> plans;
  for (const double weight : weights) {
    PlanQuery weighted = query;
    weighted.max_error.reset();
    weighted.max_blind_distance.reset();
    weighted.weight = weight;
    plans.push_back(plan(weighted, fields, options));
  }
  std::vector<PlanResult> best = plans;
  for (PlanResult& result : best) {
    for (const PlanResult& other : plans) {
      const double cost = cost_under(other, result.query.weight);
      if (other.status != PlanStatus::solved || result.status == PlanStatus::interrupted) continue;
      if (result.status == PlanStatus::solved && cost >= result.cost) continue;
      result.status = PlanStatus::solved;
      result.predicted_error = other.predicted_error;
      result.path = other.path;
      result.curves = other.curves;
      result.figures = other.figures;
      result.cost = cost;
    }
  }
  return best;
}

}  // namespace alignability
