// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "costmap/alignability_map.hpp"

namespace alignability {

/// `alpha_heading_K`: of n such layers, that of the robot's yaw 2πK/n in `map`.
std::string heading_layer_name(std::size_t heading);

/// That of n headings at yaws 2πk/n which is nearest to a yaw [rad]; n >= 1.
std::size_t nearest_heading(double yaw, std::size_t headings);

/// What is wrong with the headings that layers' names tell of: one alone, or one that is missing between others; nullopt when nothing is,
/// and where there are none.
std::optional<std::string> fault_of_heading_layers(std::span<const std::string> names);

/// α by heading, the k-th at yaw 2πk/n, of a robot whose lidar does not see all around; empty of a map that is the same at all headings.
/// They last as long as the map. Throws std::invalid_argument with the fault.
std::vector<const Grid<float>*> heading_layers(const AlignabilityMap& map);

/// Cell by cell the greatest α at any heading, NaN where it is at one; `alpha` of a map that is the same at all. Throws likewise.
Grid<float> best_over_headings(const AlignabilityMap& map);

}  // namespace alignability
