// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "costmap/grid.hpp"

namespace alignability {

/// The occupancy [%] of a cell in a mask whose share is 1: in nav2, which makes costs of 0 to 254 of percentages, the largest that is
/// neither lethal (254) nor taken for the footprint's inside of an obstacle (253).
inline constexpr int kMostOfMask = 99;
/// What nav2's costmap holds there.
inline constexpr int kMostCostOfMask = 251;

/// Writes NAME.yaml and NAME.pgm, a filter mask for map_server in mode scale: of each cell the share in [0,1] in steps of 1 / kMostOfMask,
/// NaN where nothing may enter: lethal.
/// `name` has no extension. Throws InputError when a file cannot be written, std::invalid_argument for a share out of range.
void write_cost_mask(const Grid<double>& share, const std::filesystem::path& name);

}  // namespace alignability
