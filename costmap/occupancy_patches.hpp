// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "costmap/occupancy_map.hpp"

namespace alignability {

/// What a map made of points lacks or has too much, in areas [m²] of patches: cells alike that share a side. O(cells).

/// The map with its free patches of less than that area unknown. The floor that shows within scanned walls is such.
OccupancyMap without_small_patches(const OccupancyMap& map, double area);

/// The map with its unknown patches of less than that area free, where only free cells border on them. Where points lie at random, a floor
/// has such holes.
OccupancyMap without_small_holes(const OccupancyMap& map, double area);

}  // namespace alignability
