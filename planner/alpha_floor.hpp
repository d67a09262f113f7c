// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "core/progress.hpp"
#include "planner/planar_path.hpp"

namespace alignability {

/// No way of a disk from a start to a goal keeps an alignability above this at every place, both ends included: a proof, by flooding cells,
/// those with the greatest α first, in which some point could hold the disk. nullopt where all ways lead over places without a value. The
/// motion's own floor is left out of account. O(cells · log cells). Throws Interrupted.
std::optional<double> greatest_alpha_floor(const PlanarMotion& motion, const Eigen::Vector2d& start, const Eigen::Vector2d& goal,
                                           const StopTest& stop = {});

}  // namespace alignability
