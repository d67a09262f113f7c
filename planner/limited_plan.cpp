// SPDX-License-Identifier: BSD-3-Clause
#include "planner/limited_plan.hpp"

#include <algorithm>

#include "planner/limited_path.hpp"
#include "planner/planar_plan.hpp"
#include "planner/planners.hpp"

namespace alignability {
namespace {

// Vertices that are added to a path shift the steps by which its error is predicted: by so much less than the limit the search keeps,
// the next where that was not enough.
constexpr double kStricter[] = {0.999, 0.99, 0.95};

PlanResult infeasible(const PlanResult& result) {
  PlanResult none;
  none.status = PlanStatus::infeasible;
  none.query = result.query;
  none.lower_bound = result.lower_bound;
  return none;
}

PlanResult within_error(const PlanResult& result, const ErrorModel& model, const PlanarMotion& motion, const LimitedWay& way,
                        const std::stop_token& stop) {
  const double most = *result.query.max_error;
  for (const double stricter : kStricter) {
    const auto path = path_within(motion, {model, stricter * most}, way, stop);
    if (!path) break;
    PlanResult limited = solved_along(*path, result.query, *motion.risk);
    limited.lower_bound = result.lower_bound;
    limited.predicted_error = greatest_predicted_error(limited.path, *motion.risk, model);
    if (*limited.predicted_error <= most) return limited;
  }
  PlanResult none = infeasible(result);
  // What the path without a limit comes to will do in any case.
  const auto smallest = smallest_limit(motion, model, way, stop);
  none.smallest_max_error = std::min(*result.predicted_error, smallest.value_or(*result.predicted_error) / kStricter[0]);
  return none;
}

PlanResult within_blind_distance(const PlanResult& result, const PlanarMotion& motion, const LimitedWay& way, const std::stop_token& stop) {
  const double recovery = result.query.recovery_distance;
  if (const auto path = path_within(motion, BlindLimit{*result.query.max_blind_distance, recovery}, way, stop)) {
    PlanResult limited = solved_along(*path, result.query, *motion.risk);
    limited.lower_bound = result.lower_bound;
    limited.longest_unrecovered = longest_unrecovered(limited.path, *motion.risk, recovery);
    if (*limited.longest_unrecovered <= *result.query.max_blind_distance + BlindLimit::kRounding) return limited;
  }
  PlanResult none = infeasible(result);
  const auto smallest = smallest_blind_limit(motion, recovery, way, stop);
  none.smallest_max_blind_distance = std::min(*result.longest_unrecovered, smallest.value_or(*result.longest_unrecovered));
  return none;
}

}  // namespace

std::optional<std::string> refusal_of_limit(const PlanQuery& query, const std::optional<ErrorModel>& model) {
  if (!query.max_error && !query.max_blind_distance) return std::nullopt;
  if (query.max_error && query.max_blind_distance) return "give a limit of the error or one of blind metres, not both";
  if (query.max_error && !model) return "a limit of the error needs an alignability map with an error model: 'calibrate' makes one";
  if (is_curved(query.motion.space)) return "limits of the error and of blind metres are kept in the spaces r2 and se2 alone";
  if (query.planner.name == kDefaultPlanner) return std::nullopt;
  return std::string(query.max_error ? "a limit of the error" : "a limit of blind metres") + " is kept by the planner '" + kDefaultPlanner +
         "' alone";
}

PlanResult within_limit(PlanResult result, const std::optional<ErrorModel>& model, const DrivableArea& area, const std::stop_token& stop) {
  const PlanQuery& query = result.query;
  const PlanarMotion motion{area.risk_field(), area.clearance_map(), query.weight, area.circumscribed_radius()};
  // Short of the tolerance by as much as the path is cut.
  const LimitedWay way{query.start.position(), query.goal.position(), (1.0 - 1e-6) * query.goal_tolerance.position};
  if (model) result.predicted_error = greatest_predicted_error(result.path, *motion.risk, *model);
  if (query.max_error && *result.predicted_error > *query.max_error) return within_error(result, *model, motion, way, stop);
  if (query.max_blind_distance) {
    result.longest_unrecovered = longest_unrecovered(result.path, *motion.risk, query.recovery_distance);
    if (*result.longest_unrecovered > *query.max_blind_distance + BlindLimit::kRounding)
      return within_blind_distance(result, motion, way, stop);
  }
  return result;
}

}  // namespace alignability
