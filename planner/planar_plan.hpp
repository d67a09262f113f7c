// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planner/plan.hpp"
#include "planner/planar_path.hpp"

namespace alignability {

/// A solved plan along a path of the plane, up to where it first comes within the goal's tolerance; a disk turns evenly along it. What took
/// time and what bounds say is left open.
PlanResult solved_along(const PlanarPath& path, const PlanQuery& query, const RiskField& risk);

}  // namespace alignability
