// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "cli/json.hpp"
#include "cli/output_name.hpp"
#include "planner/evaluate.hpp"

namespace alignability::cli {

/// A route, and what it was scored with and how.
struct EvaluatedRoute {
  Route route;
  PlanProblem problem;
  Evaluation evaluation;
};

/// As a plan's, with `status` and `obstruction` of the route, and for a graph `edges`, the worst first.
Json evaluation_json(const EvaluatedRoute& evaluated);

/// A path's figures, or a graph's edges in a table, the worst first, and below them all together.
void print_evaluation(const EvaluatedRoute& evaluated);

/// "the robot collides at x 3.60, y 5.00" for a way that is obstructed.
std::string obstruction_text(const WayEvaluation& way);

/// NAME.json, NAME.csv and NAME.png, or the picture as other kinds.
void write_evaluation(const EvaluatedRoute& evaluated, const RiskField& risk, const std::filesystem::path& name, const PictureKinds& kinds);

}  // namespace alignability::cli
