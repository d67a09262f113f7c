// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <stop_token>

#include "cli/output_name.hpp"
#include "planner/plan_problem.hpp"

namespace alignability::cli {

struct StationsRun {
  std::filesystem::path stations;
  bool json = false;
  std::optional<std::filesystem::path> output;
  PictureKinds pictures;
};

/// Plans between all stations of a file and says what came of it; no, where some way was not found. Throws InputError and Interrupted.
int plan_stations(const PlanProblem& problem, const StationsRun& run, const std::stop_token& stop);

}  // namespace alignability::cli
