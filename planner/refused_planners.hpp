// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "planner/plan_problem.hpp"

namespace alignability {

/// Why one of OMPL 1.5.2's geometric planners is not offered: it would lie about the cost, or pay it no heed; nullptr for other names.
const char* reason_against(const std::string& name);
/// Why one that is offered elsewhere is not in a space.
const char* reason_against(const std::string& name, MotionSpace space);

std::vector<std::string> refused_planner_names();

}  // namespace alignability
