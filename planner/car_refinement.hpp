// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/progress.hpp"
#include "planner/car_task.hpp"

namespace alignability {

/// The poses of a car's path freed of the grid that they were found on: shortcuts by curves, then poses moved, turned and added as long as
/// that lowers the exact cost and keeps the task's limits, the last within the goal's tolerance. The curves between are drivable where they
/// were, and never cost more. Comes to an end early when told to stop.
std::vector<Pose2> refined(std::vector<Pose2> path, const CarTask& task, const StopTest& stop);

}  // namespace alignability
