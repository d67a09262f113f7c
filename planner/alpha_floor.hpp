// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "planner/planar_path.hpp"

namespace alignability {

/// The greatest alignability that some way from a start to a goal keeps at every place, both ends included, over the corners of the map's
/// cells, rounded down to a thousandth; nullopt where every way leads over places without a value. The motion's own floor is left out of
/// account. O(cells).
std::optional<double> greatest_alpha_floor(const PlanarMotion& motion, const Eigen::Vector2d& start, const Eigen::Vector2d& goal);

}  // namespace alignability
