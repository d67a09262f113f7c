// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <filesystem>

#include "cli/json.hpp"
#include "cli/output_name.hpp"
#include "costmap/alignability_map.hpp"
#include "costmap/occupancy_map.hpp"

namespace alignability::cli {

/// Draws the map and writes it: NAME.png or other kinds, NAME.tiff and, last, NAME.yaml.
void store_map(const AlignabilityMap& map, const OccupancyMap& occupancy, const std::filesystem::path& name, const PictureKinds& kinds);

/// What stands for the occupancy map where there is none: all is free.
OccupancyMap open_ground(const GridGeometry& cells);

/// NAME.yaml, NAME.tiff and the pictures.
std::vector<std::filesystem::path> map_files(const std::filesystem::path& name, const PictureKinds& kinds);

/// On stdout, as JSON or in words.
void tell(const Json& summary, bool json);

double seconds_since(std::chrono::steady_clock::time_point begin);

}  // namespace alignability::cli
