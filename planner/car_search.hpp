// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "core/progress.hpp"
#include "planner/car_task.hpp"
#include "planner/cost_bound.hpp"

namespace alignability {

/// Poses by which a car gets from the start to the goal's pose, each joined to the next by the steering's curve, near the cheapest way
/// there is: A* over poses told apart by a grid of places and headings, by arcs of the turning radius and straights, each checked and
/// priced exactly; to the goal by a curve. What is left to go it takes from the plane's bound and from the curve's length without
/// obstacles, somewhat more than that, for a search far narrower. Of two ways to a place and heading, under the task's limits, one is
/// dropped where the other is neither dearer nor, but for a fiftieth of what they allow, in a worse state. Finer grids where one finds
/// none. nullopt where none does. Throws Interrupted.
std::optional<std::vector<Pose2>> search_car_path(const CarTask& task, const CostBound& to_go, const StopTest& stop);

}  // namespace alignability
