// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "core/progress.hpp"
#include "planner/plan.hpp"
#include "planner/station_file.hpp"

namespace alignability {

struct StationMatrixOptions {
  ProgressCallback progress = {};  ///< counts stations
  std::stop_token stop = {};
};

/// A plan from each station to each other, [from][to], to within a micrometre; on the diagonal one that stands. They are what the planner
/// `field` makes. Of a disk, which turns evenly, the way back is the way there: one field a station, O(stations · cells), and what refining
/// stations² / 2 paths takes; no lower bounds are sought. A footprint, a car, what has limits that depend on the way and what has risk by
/// heading are planned for pair by pair, and so is a disk where its field has no way, to tell why. What the query says of start, goal, its
/// tolerance and the planner's name is left out of account. Throws Interrupted, and as plan does.
std::vector<std::vector<PlanResult>> plan_between(std::span<const Station> stations, const PlanQuery& query, const PlanningFields& fields,
                                                  const StationMatrixOptions& options);

}  // namespace alignability
