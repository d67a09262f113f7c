// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "planner/plan_problem.hpp"

namespace alignability::cli {

/// A problem file and what the command line puts in the place of its keys.
struct ProblemOptions {
  std::filesystem::path file;
  std::optional<std::filesystem::path> map;
  std::optional<std::filesystem::path> alignability;
  std::optional<std::string> planner;
  std::optional<double> time;
  std::optional<std::int64_t> iterations;
  std::optional<std::uint32_t> seed;
  std::optional<double> weight;
  std::vector<double> start;  // empty, or x, y, yaw
  std::vector<double> goal;
};

void add_problem_options(CLI::App& command, ProblemOptions& options);

/// The problem file with what the command line says.
ProblemFile problem_file(const ProblemOptions& options);

/// The same with its maps read.
PlanProblem load(const ProblemOptions& options);

}  // namespace alignability::cli
