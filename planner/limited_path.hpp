// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "core/progress.hpp"
#include "planner/path_limits.hpp"
#include "planner/planar_path.hpp"

namespace alignability {

/// From where to where, and how near that is near enough [m]: within it the limits need not be kept.
struct LimitedWay {
  Eigen::Vector2d start;
  Eigen::Vector2d goal;
  double tolerance = 0.0;
};

/// Whether a path keeps limits, from a start at which the robot is localized as well as it can be. O(length).
bool keeps(const PlanarPath& path, const PlanarMotion& motion, const PathLimits& limits);

/// A path from a start to a goal on which limits are kept up to the tolerance, the cheapest found. What may come of a place depends on the
/// state in which the robot gets there, its error or how long it has been blind, so the search goes over places of a lattice and states at
/// once (LimitedSearch): of two ways to a place one is dropped where the other is neither dearer nor in a worse state by more than a
/// fiftieth of a limit; where that loses the way, by a thousandth, and then the first way found is taken. The path is then freed of the
/// lattice as far as the limits allow. The lattice has places every 0.5 m, or every 0.25 m where there is no way on that: a narrow passage
/// may be passed over for a detour. nullopt where none is found. Throws Interrupted. Both places must be allowed.
std::optional<PlanarPath> path_within(const PlanarMotion& motion, const PathLimits& limits, const LimitedWay& way, const StopTest& stop);

/// The smallest limit, in place of the one given, with which there is a way on a lattice of 0.25 m that keeps the other one too, if there
/// is one: to within 1 % or 1 mm; nullopt where there is none with any. Throws Interrupted. There must be a limit of that kind.
std::optional<double> smallest_max_error(const PlanarMotion& motion, const PathLimits& limits, const LimitedWay& way, const StopTest& stop);
std::optional<double> smallest_max_blind_distance(const PlanarMotion& motion, const PathLimits& limits, const LimitedWay& way,
                                                  const StopTest& stop);

}  // namespace alignability
