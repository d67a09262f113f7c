// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "core/pose.hpp"
#include "costmap/grid.hpp"
#include "costmap/occupancy_map.hpp"

namespace alignability {

struct ErrorMapOptions {
  std::string title;   ///< none when empty
  double limit = 0.5;  ///< of the scale of colours, which starts at 0; larger errors have the last colour [m]
  std::string label = "mean error [m]";
};

/// Draws a localization error per cell [m], NaN = not driven through and grey, from pale yellow at 0 over red to dark violet at the limit,
/// the walls in dark grey, and the route that was driven as a thin line; without poses there is none. Poses that are not finite leave a
/// gap. Its size is that of `draw_alignability_map`. Throws std::invalid_argument unless the limit is positive and finite, InputError
/// when the file is not named .png, .svg or .pdf, or cannot be written.
void draw_error_map(const Grid<float>& error, const OccupancyMap& occupancy, std::span<const Pose2> route, const ErrorMapOptions& options,
                    const std::filesystem::path& file);

}  // namespace alignability
