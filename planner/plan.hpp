// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

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
  PlanQuery query;          ///< as planned, the planner's name filled in
  std::vector<Pose2> path;  ///< from the start to within the goal's tolerance, straight between; empty unless solved
  double cost = 0.0;        ///< of that path [equivalent m]
  PathFigures figures;
  double seconds = 0.0;
  std::optional<double> first_solution_seconds;  ///< from the call, fields included
};

/// Plans with OMPL. Seeds OMPL's generators, which the whole process shares: one plan at a time. With `iterations` and a
/// single-threaded planner, the same problem gives the same path. An interrupted plan has no path.
/// Throws std::invalid_argument for a query out of range.
PlanResult plan(const PlanProblem& problem, const PlanOptions& options);

}  // namespace alignability
