// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "costmap/map_comparison.hpp"
#include "costmap/occupancy_map.hpp"

namespace alignability {

/// Draws by how much α of the second map differs from that of the first, on the first map's cells: red where it is lower, white where it
/// is the same, blue where it is higher, grey where one has no value, and a frame around the cells that are lower than chance explains.
/// The scale ends at the largest difference, rounded up to a tenth. Walls, the unknown and the picture's size are as
/// `draw_alignability_map` has them; without a title there is none. Throws InputError when the file is not named .png, .svg or .pdf, or
/// cannot be written.
void draw_alignability_difference(const MapComparison& comparison, const GridGeometry& cells, const OccupancyMap& occupancy,
                                  const std::string& title, const std::filesystem::path& file);

}  // namespace alignability
