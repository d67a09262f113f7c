// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "planner/error_limit.hpp"
#include "planner/planar_path.hpp"

namespace alignability {

/// Whether a path keeps a limit, from a start at which the robot is localized as well as it can be. O(length).
bool keeps(const PlanarPath& path, const PlanarMotion& motion, const ErrorLimit& limit);

/// The cheapest path found from a start to a goal on which a limit is kept. What may come of a place depends on the error with which the
/// robot gets there, so the search goes over places of a lattice and errors at once: of two ways to a place one is dropped where the other
/// is neither dearer nor less sure (labels in the order of cost by A*, after Handler and Zang 1980); errors that differ by less than a
/// fiftieth of the limit count as one. The path is then freed of the lattice as far as the limit allows. nullopt where none is found on a
/// lattice of 0.25 m. Both places must be allowed. O(lattice's places · 50).
std::optional<PlanarPath> path_within(const PlanarMotion& motion, const ErrorLimit& limit, const Eigen::Vector2d& start,
                                      const Eigen::Vector2d& goal);

/// The smallest limit, to within 2 %, with which path_within finds a path; nullopt where it finds none with any.
std::optional<double> smallest_limit(const PlanarMotion& motion, const ErrorModel& model, const Eigen::Vector2d& start,
                                     const Eigen::Vector2d& goal);

}  // namespace alignability
