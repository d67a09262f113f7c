// SPDX-License-Identifier: BSD-3-Clause
#include "planner/planar_plan.hpp"

#include "planner/heading_search.hpp"
#include "planner/headings.hpp"

namespace alignability {
namespace {

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

PlanResult solved_along(const PlanarPath& path, const PlanQuery& query, const RiskField& risk) {
  PlanResult result;
  result.status = PlanStatus::solved;
  result.query = query;
  // Short of the tolerance by more than rounding, so that it is met.
  result.path = with_headings(cut_within(path, (1.0 - 1e-6) * query.goal_tolerance.position), query);
  result.figures = measure(result.path, risk);
  result.cost = cost_of(result.figures, query);
  return result;
}

}  // namespace alignability
