// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "costmap/clearance_map.hpp"
#include "planner/curve.hpp"
#include "planner/path_figures.hpp"
#include "planner/plan_problem.hpp"

namespace alignability {

enum class PlanStatus {
  solved,
  no_path,  ///< proven: the goal is walled off
  timeout,
  infeasible,
  start_in_collision,
  goal_in_collision,
  start_outside_map,
  goal_outside_map,
  interrupted,
};

/// The name of a status as `--json` has it.
const char* to_string(PlanStatus status);

struct PlanOptions {
  std::stop_token stop;
};

struct PlanResult {
  PlanStatus status = PlanStatus::timeout;
  PlanQuery query;  ///< as planned, the planner's name filled in, the risk's options those of the fields
  /// From the start to within the goal's tolerance, straight between; empty unless solved. In R² each looks to the next place, and where
  /// risk depends on heading the robot turns on the spot, a pose before and one after. In curved spaces poses along the curves, nowhere
  /// further than kLargestSagitta from what is driven, and as dense as it takes for the straights between to be drivable too.
  std::vector<Pose2> path;
  std::vector<Curve> curves;          ///< in curved spaces what is driven, one from where the last ends; cost and figures are its
  double cost = 0.0;                  ///< of that path [equivalent m]
  std::optional<double> lower_bound;  ///< certified: no path from the start to the goal costs less; nullopt where none was sought
  PathFigures figures;
  std::optional<double> predicted_error;      ///< the greatest on the path, 95th percentile [m]; nullopt without an error model
  std::optional<double> longest_unrecovered;  ///< the most blind metres without finding itself [m]; nullopt without a limit of them
  /// Of an infeasible query: limits with which a path was found, of the kind that was asked for.
  std::optional<double> smallest_max_error;
  std::optional<double> smallest_max_blind_distance;
  std::optional<double> greatest_min_alpha;
  double seconds = 0.0;                          ///< the fields' construction included
  std::optional<double> first_solution_seconds;  ///< likewise; nullopt without a solution, and of planners that do not tell
};

/// What all plans on one site and one reading of its risk share. O(cells) to build; immutable.
struct PlanningFields {
  explicit PlanningFields(const PlanProblem& problem);

  std::shared_ptr<const RiskField> risk;
  std::shared_ptr<const ClearanceMap> clearance;
  std::optional<ErrorModel> error_model;
  double seconds = 0.0;  ///< that building them took
};

/// Plans with OMPL. Where the path would break the query's `max_error` or `max_blind_distance`, a search over places and states looks for
/// one that keeps both, for the disk around the robot (see path_within) or for the car (see car_path); infeasible where it finds none, and
/// where every way, start and goal included, leads over places below the floor of α. Seeds OMPL's generators, which the whole process
/// shares: one plan at a time. With `iterations` and a single-threaded planner, the same problem gives the same path. An interrupted plan
/// has no path. Throws std::invalid_argument for a query out of range, a `max_error` without an error model or with another planner
/// than `field`, and for what takes no notice of headings on a map that has them (see refusal_by_headings).
PlanResult plan(const PlanQuery& query, const PlanningFields& fields, const PlanOptions& options);
PlanResult plan(const PlanProblem& problem, const PlanOptions& options);

}  // namespace alignability
