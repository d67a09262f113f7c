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

/// A plan from each station to each other, [from][to], exactly to its pose; on the diagonal one that stands. They are what the planner
/// `field` makes for the disk around the robot, which turns evenly, the way back being the way there. Where that has no way, a plan of its
/// own is made for the robot itself. One field a station: O(stations · cells), and what refining stations² / 2 paths takes. What the query
/// says of start, goal, its tolerance and the planner is left out of account; no lower bounds are sought. Throws Interrupted, and
/// std::invalid_argument where the query has a limit that depends on the way.
std::vector<std::vector<PlanResult>> plan_between(std::span<const Station> stations, const PlanQuery& query, const PlanningFields& fields,
                                                  const StationMatrixOptions& options);

}  // namespace alignability
