// SPDX-License-Identifier: BSD-3-Clause
#include "planner/limited_plan.hpp"

#include <algorithm>

#include "planner/heading_search.hpp"
#include "planner/headings.hpp"
#include "planner/limited_path.hpp"
#include "planner/planners.hpp"

namespace alignability {
namespace {

// Vertices that are added to a path shift the steps by which its error is predicted: by so much less than the limit the search keeps,
// the next where that was not enough.
constexpr double kStricter[] = {0.999, 0.99, 0.95};

std::vector<Pose2> with_headings(const PlanarPath& path, const PlanQuery& query) {
  if (query.motion.space == MotionSpace::se2) return turning_evenly(path, {query.start.yaw, query.goal.yaw, query.goal_tolerance.heading});
  std::vector<Pose2> poses;
  for (const Eigen::Vector2d& place : path) poses.push_back({place.x(), place.y(), 0.0});
  return looking_ahead(std::move(poses), query.start.yaw);
}

double cost_of(const PathFigures& figures, const PlanQuery& query) {
  const double turning = query.motion.space == MotionSpace::se2 ? query.motion.turn_cost * figures.turned : 0.0;
  return figures.length + query.weight * figures.risk_integral + turning;
}

}  // namespace

std::optional<std::string> refusal_of_limit(const PlanQuery& query, const std::optional<ErrorModel>& model) {
  if (!query.max_error) return std::nullopt;
  if (!model) return "a limit of the error needs an alignability map with an error model: 'calibrate' makes one";
  if (query.planner.name != kDefaultPlanner)
    return std::string("a limit of the error is kept by the planner '") + kDefaultPlanner + "' alone";
  if (is_curved(query.motion.space)) return "a limit of the error is kept in the spaces r2 and se2 alone";
  return std::nullopt;
}

PlanResult within_limit(PlanResult result, const ErrorModel& model, const DrivableArea& area, const std::stop_token& stop) {
  const PlanQuery& query = result.query;
  const RiskField& risk = *area.risk_field();
  result.predicted_error = greatest_predicted_error(result.path, risk, model);
  if (!query.max_error || *result.predicted_error <= *query.max_error) return result;
  const PlanarMotion motion{area.risk_field(), area.clearance_map(), query.weight, area.circumscribed_radius()};
  const Eigen::Vector2d start = query.start.position();
  const Eigen::Vector2d goal = query.goal.position();
  for (const double stricter : kStricter) {
    const auto planar = path_within(motion, {model, stricter * *query.max_error}, start, goal, stop);
    if (!planar) break;
    // Short of the tolerance by more than rounding, so that it is met.
    std::vector<Pose2> path = with_headings(cut_within(*planar, (1.0 - 1e-6) * query.goal_tolerance.position), query);
    const double error = greatest_predicted_error(path, risk, model);
    if (error > *query.max_error) continue;
    result.path = std::move(path);
    result.predicted_error = error;
    result.figures = measure(result.path, risk);
    result.cost = cost_of(result.figures, query);
    return result;
  }
  PlanResult none;
  none.status = PlanStatus::infeasible;
  none.query = query;
  none.lower_bound = result.lower_bound;
  // What the path without a limit comes to will do in any case.
  const auto smallest = smallest_limit(motion, model, start, goal, stop);
  none.smallest_max_error = std::min(*result.predicted_error, smallest.value_or(*result.predicted_error) / kStricter[0]);
  return none;
}

}  // namespace alignability
