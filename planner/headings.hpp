// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "core/pose.hpp"

namespace alignability {

/// The straight motion from one place to another, facing where it goes. Two places must be two.
std::pair<Pose2, Pose2> facing_ahead(const Eigen::Vector2d& from, const Eigen::Vector2d& to);

/// The same places, each pose looking to the next place that is another; those at the end look as the last that has one ahead. A path
/// that stays in one place looks to `standing` [rad].
std::vector<Pose2> looking_ahead(std::vector<Pose2> path, double standing);

/// The same way with each heading held along its segment: where the next pose has another, a turn on the spot before it.
std::vector<Pose2> turning_on_the_spot(const std::vector<Pose2>& path);

}  // namespace alignability
