// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "planner/drivable_area.hpp"
#include "planner/planar_path.hpp"

namespace alignability {

/// The headings to begin with and to end in, the latter to within a tolerance [rad].
struct HeadingEnds {
  double start = 0.0;
  double goal = 0.0;
  double tolerance = 0.0;
};

/// The path with headings that turn no more than they must: evenly, all the way, by what the goal's tolerance leaves of the turn.
std::vector<Pose2> turning_evenly(const PlanarPath& path, const HeadingEnds& ends);

/// What headings are chosen by: of the ways along a path, that of the least cost.
struct HeadingPrice {
  double of_turning = 1.0;  ///< of a radian, >= 0
  double of_risk = 0.0;     ///< of a metre at risk, >= 0
};

/// The path with headings under which the robot never collides, by Dijkstra's algorithm over 72 headings at every few decimetres, each
/// motion checked: of these the one of the least price. nullopt when there is none.
std::optional<std::vector<Pose2>> turning_clear(const PlanarPath& path, const HeadingEnds& ends, const DrivableArea& area,
                                                const HeadingPrice& price);

}  // namespace alignability
