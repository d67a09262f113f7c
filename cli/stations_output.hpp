// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "cli/json.hpp"
#include "planner/station_matrix.hpp"

namespace alignability::cli {

/// Plans between stations, [from][to].
using StationPlans = std::vector<std::vector<PlanResult>>;

/// {stations, status, cost, length, blind_length, risk_integral, paths, seconds}, each but the first and the last [from][to].
Json stations_json(std::span<const Station> stations, const StationPlans& plans, double seconds);

/// `from,to,status,cost,length,blind,longest_blind,risk_integral`, a line a pair.
void write_stations_csv(std::span<const Station> stations, const StationPlans& plans, const std::filesystem::path& csv);

/// The matrix of costs, and what is to be told of ways that there are not.
void print_stations(std::span<const Station> stations, const StationPlans& plans, double seconds);

}  // namespace alignability::cli
