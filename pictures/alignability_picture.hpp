// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "costmap/alignability_map.hpp"
#include "costmap/occupancy_map.hpp"
#include "costmap/risk_field.hpp"

namespace alignability {

struct MapPictureOptions {
  std::string title;  ///< none when empty
  RiskOptions risk;   ///< its thresholds are marked on the scale of α
};

/// Draws the `alpha` layer, x to the right and y up: red at α = 0 over pale yellow to blue at 1, grey where it was not evaluated, the
/// unknown hatched and walls black at the resolution of the occupancy map. The longer side of the map is 900 to 1900 px, less where an
/// α-cell would exceed 120 px, whatever its size in cells. Of a map with layers by heading (see heading_layers) `alpha` is that of the
/// worst; below are the others, small, each under an arrow. Throws InputError when the file is not named .png, .svg or .pdf, or cannot be
/// written.
void draw_alignability_map(const AlignabilityMap& map, const OccupancyMap& occupancy, const MapPictureOptions& options,
                           const std::filesystem::path& file);

}  // namespace alignability
