// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "planner/plan.hpp"

namespace alignability {

/// The query planned once for each weight (>= 0), in their order. Of all paths found, each weight gets the one that costs least under it,
/// so that with the weight the risk integral never rises and the rest of the cost never falls, whatever a planner's luck; times stay those
/// of the weight's own plan. Throws as plan does.
std::vector<PlanResult> trade_off(const PlanQuery& query, const PlanningFields& fields, std::span<const double> weights,
                                  const PlanOptions& options);

/// The shortest path within each limit of blind metres (>= 0, in place of the query's limits and weight), in their order. Of all paths
/// found, and those `known` of the same query under other weights, each limit gets the shortest that keeps it, so that with the limit no
/// length rises; times stay those of the limit's own plan. What cannot be kept is infeasible. Throws as plan does.
std::vector<PlanResult> blind_trade_off(const PlanQuery& query, const PlanningFields& fields, std::span<const double> limits,
                                        std::span<const PlanResult> known, const PlanOptions& options);

}  // namespace alignability
