// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/progress.hpp"
#include "planner/car_task.hpp"

namespace alignability {

/// Poses by which a car gets from the start to within the goal's tolerance near the cheapest way there is, each joined to the next by the
/// steering's curve (see search_car_path, refined); nullopt where none is found. Throws Interrupted where it is told to stop before it has
/// any.
std::optional<std::vector<Pose2>> car_path(const CarTask& task, const StopTest& stop);

/// The curves between poses.
std::vector<Curve> curves_through(std::span<const Pose2> poses, const Steering& steering);

/// Poses along curves, nowhere further than kLargestSagitta from what is driven, and as dense as it takes for the straights between to be
/// drivable too.
std::vector<Pose2> driven_poses(std::span<const Curve> curves, const DrivableArea& area);

}  // namespace alignability
