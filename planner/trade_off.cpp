// SPDX-License-Identifier: BSD-3-Clause
#include "planner/trade_off.hpp"

#include <algorithm>

#include "planner/blind_limit.hpp"

namespace alignability {
namespace {

// What a result's path costs under another weight: it is linear in it.
double cost_under(const PlanResult& result, double weight) {
  return result.cost + (weight - result.query.weight) * result.figures.risk_integral;
}

void take_path(PlanResult& result, const PlanResult& other, double cost) {
  result.status = PlanStatus::solved;
  result.cost = cost;
  result.path = other.path;
  result.curves = other.curves;
  result.figures = other.figures;
  result.predicted_error = other.predicted_error;
  result.longest_unrecovered = other.longest_unrecovered;
}

bool would_gain(const PlanResult& result, double cost) {
  return result.status == PlanStatus::solved ? cost < result.cost : result.status != PlanStatus::interrupted;
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
      if (other.status == PlanStatus::solved && would_gain(result, cost)) take_path(result, other, cost);
    }
  }
  return best;
}

std::vector<PlanResult> blind_trade_off(const PlanQuery& query, const PlanningFields& fields, std::span<const double> limits,
                                        std::span<const PlanResult> known, const PlanOptions& options) {
  std::vector<PlanResult> plans;
  for (const double limit : limits) {
    PlanQuery limited = query;
    limited.weight = 0.0;
    limited.max_error.reset();
    limited.max_blind_distance = limit;
    plans.push_back(plan(limited, fields, options));
  }
  std::vector<PlanResult> best = plans;
  for (PlanResult other : known) {
    other.cost = cost_under(other, 0.0);
    other.longest_unrecovered = longest_unrecovered(other.path, *fields.risk, query.recovery_distance);
    plans.push_back(std::move(other));
  }
  for (PlanResult& result : best) {
    for (const PlanResult& other : plans) {
      if (other.status != PlanStatus::solved || *other.longest_unrecovered > *result.query.max_blind_distance) continue;
      if (would_gain(result, other.cost)) take_path(result, other, other.cost);
    }
  }
  return best;
}

}  // namespace alignability
