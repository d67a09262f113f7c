// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "planner/path_figures.hpp"
#include "planner/plan.hpp"
#include "planner/route.hpp"

namespace alignability {

/// Whether a robot can drive a way, and what is first in its way.
enum class RouteStatus {
  solved,  ///< as a plan's: it can
  in_collision,
  outside_map,  ///< the robot's outline leaves the occupancy map
  unevaluated,  ///< nobody evaluated a place, and UnknownPolicy::blocked keeps the robot out of it
};

/// The name of a status as `--json` has it.
const char* to_string(RouteStatus status);

/// What a way is worth, obstructed or not. Off the map, where nothing is known, figures are those of the nearest place on its edge.
struct WayEvaluation {
  RouteStatus status = RouteStatus::solved;
  std::optional<Pose2> obstruction;  ///< the first pose that the robot cannot take, to a billionth of the segment; nullopt if solved
  double cost = 0.0;                 ///< as a plan's [equivalent m]
  PathFigures figures;
};

struct EdgeEvaluation {
  RouteEdge edge;
  WayEvaluation way;
};

struct Evaluation {
  WayEvaluation total;                ///< of a graph the sum over all edges, the longest blind of any edge, the worst edge's status
  std::vector<EdgeEvaluation> edges;  ///< of a graph: obstructed ones first, then by risk integral, the highest first
  double seconds = 0.0;               ///< the fields' construction included
};

/// Scores a route as `plan` does its paths. Of the query, start, goal and planner have no part in it. Collisions are found exactly,
/// not by sampling. O(α-cells and occupancy cells crossed).
/// Throws std::invalid_argument for a robot without a positive radius or a simple footprint, and a route without any way.
Evaluation evaluate(const Route& route, const PlanQuery& query, const PlanningFields& fields);

}  // namespace alignability
