// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ompl/base/ProblemDefinition.h>
#include <ompl/geometric/PathGeometric.h>

#include "core/progress.hpp"

namespace alignability {

/// The path after OMPL's shortcuts and perturbations by the objective of the problem; the path itself where they bring nothing. Never
/// costs more, is valid, starts where it did and ends in the goal. The number of trials is fixed, so that seeds repeat, but where
/// it is told to stop.
ompl::geometric::PathGeometric shortened(const ompl::geometric::PathGeometric& path, const ompl::base::ProblemDefinition& problem,
                                         const StopTest& stop);

}  // namespace alignability
