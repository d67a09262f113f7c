// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planner/plan_problem.hpp"

namespace alignability::python {

/// What to plan, and what a problem file says beside it of what drives.
struct Problem {
  PlanProblem plan;
  ProblemFile file = {};
};

}  // namespace alignability::python
