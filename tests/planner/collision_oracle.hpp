// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "costmap/occupancy_map.hpp"
#include "planner/robot.hpp"

namespace alignability::test {

/// By Boost's polygons, cell by cell, with none of the planner's code; the map's edge is the wall around it.
bool collides(const OccupancyMap& map, const std::vector<Eigen::Vector2d>& corners);

/// The first place, every centimetre or so of a path, where the robot collides; nullopt when there is none.
std::optional<Pose2> first_collision(const OccupancyMap& map, const Robot& robot, std::span<const Pose2> path);

}  // namespace alignability::test
