// SPDX-License-Identifier: BSD-3-Clause
#include "planner/evaluate.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "planner/drivable_area.hpp"

namespace alignability {
namespace {

class WayJudge {
 public:
  WayJudge(const PlanQuery& query, const PlanningFields& fields)
      : query_(query), fields_(fields), area_(fields.clearance, fields.risk, query.robot) {}

  WayEvaluation judge(const std::vector<Pose2>& path) const {
    WayEvaluation way;
    way.figures = measure(path, *fields_.risk);
    const double turn_cost = query_.motion.space == MotionSpace::r2 ? 0.0 : query_.motion.turn_cost;
    way.cost = way.figures.length + query_.weight * way.figures.risk_integral + turn_cost * way.figures.turned;
    find_obstruction(path, way);
    return way;
  }

 private:
  void find_obstruction(const std::vector<Pose2>& path, WayEvaluation& way) const {
    for (std::size_t i = 0; i < path.size(); ++i) {
      const Pose2& from = path[i == 0 ? 0 : i - 1];
      if (area_.contains(from, path[i])) continue;
      way.obstruction = first_obstruction(from, path[i]);
      way.status = reason(from, *way.obstruction);
      return;
    }
  }

  // Of a segment that the area does not contain.
  Pose2 first_obstruction(const Pose2& from, const Pose2& to) const {
    if (!area_.contains(from)) return from;
    double clear = 0.0;
    double obstructed = 1.0;
    while (obstructed - clear > 1e-9) {
      const double middle = 0.5 * (clear + obstructed);
      (area_.contains(between(from, to, clear), between(from, to, middle)) ? clear : obstructed) = middle;
    }
    return between(from, to, obstructed);
  }

  RouteStatus reason(const Pose2& from, const Pose2& obstruction) const {
    if (!fits_on_map(obstruction)) return RouteStatus::outside_map;
    return fields_.risk->is_drivable_along(from, obstruction) ? RouteStatus::in_collision : RouteStatus::unevaluated;
  }

  // Whether the robot's outline stays clear of the map's edge.
  bool fits_on_map(const Pose2& pose) const {
    const GridGeometry& map = area_.geometry();
    // A footprint that turns is refused where it comes nearer than a thousandth of a cell.
    const double margin = 2e-3 * map.resolution + (query_.robot.footprint.empty() ? query_.robot.radius : 0.0);
    std::vector<Eigen::Vector2d> outline = footprint_at(query_.robot, pose);
    outline.push_back(pose.position());
    return std::ranges::all_of(outline, [&](const Eigen::Vector2d& corner) {
      return (corner - map.origin).minCoeff() > margin && (map.upper_corner() - corner).minCoeff() > margin;
    });
  }

  const PlanQuery& query_;
  const PlanningFields& fields_;
  DrivableArea area_;
};

bool is_worse(const EdgeEvaluation& a, const EdgeEvaluation& b) {
  const bool a_obstructed = a.way.status != RouteStatus::solved;
  const bool b_obstructed = b.way.status != RouteStatus::solved;
  return a_obstructed != b_obstructed ? a_obstructed : a.way.figures.risk_integral > b.way.figures.risk_integral;
}

// Of edges with the worst first.
WayEvaluation sum(const std::vector<EdgeEvaluation>& edges) {
  WayEvaluation total;
  total.status = edges.front().way.status;
  total.obstruction = edges.front().way.obstruction;
  PathFigures& figures = total.figures;
  figures.alpha_min = std::numeric_limits<double>::quiet_NaN();
  figures.risk_by_source.resize(edges.front().way.figures.risk_by_source.size(), 0.0);
  double alpha_integral = 0.0;
  for (const EdgeEvaluation& edge : edges) {
    const PathFigures& own = edge.way.figures;
    total.cost += edge.way.cost;
    figures.length += own.length;
    figures.turned += own.turned;
    figures.risk_integral += own.risk_integral;
    for (std::size_t i = 0; i < own.risk_by_source.size(); ++i) figures.risk_by_source[i] += own.risk_by_source[i];
    figures.blind_length += own.blind_length;
    figures.longest_blind = std::max(figures.longest_blind, own.longest_blind);
    figures.evaluated_length += own.evaluated_length;
    if (own.evaluated_length > 0.0) alpha_integral += own.evaluated_length * own.alpha_mean;
    figures.alpha_min = std::fmin(figures.alpha_min, own.alpha_min);
  }
  figures.alpha_mean = figures.evaluated_length > 0.0 ? alpha_integral / figures.evaluated_length : figures.alpha_min;
  return total;
}

}  // namespace

const char* to_string(RouteStatus status) {
  switch (status) {
    case RouteStatus::solved:
      return "solved";
    case RouteStatus::in_collision:
      return "in_collision";
    case RouteStatus::outside_map:
      return "outside_map";
    case RouteStatus::unevaluated:
      return "unevaluated";
  }
  return "";
}

Evaluation evaluate(const Route& route, const PlanQuery& query, const PlanningFields& fields) {
  if (route.path.empty() && route.graph.edges.empty()) throw std::invalid_argument("a route needs a path or edges");
  const auto begin = std::chrono::steady_clock::now();
  const WayJudge judge(query, fields);
  Evaluation evaluation;
  if (!route.path.empty()) {
    evaluation.total = judge.judge(route.path);
  } else {
    for (const RouteEdge& edge : route.graph.edges) evaluation.edges.push_back({edge, judge.judge(edge.path)});
    std::ranges::stable_sort(evaluation.edges, is_worse);
    evaluation.total = sum(evaluation.edges);
  }
  evaluation.seconds = fields.seconds + std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return evaluation;
}

}  // namespace alignability
