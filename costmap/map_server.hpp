// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "costmap/occupancy_map.hpp"

namespace alignability {

/// Reads a map_server map, NAME.yaml and the PGM, PPM or PNG that it names, as nav2's loader up to ROS 2 Jazzy does, to the percent. The
/// shade g of a pixel (0 black … 1 white, the mean of its colours) is an occupancy of 1 - g, of g when `negate`. Mode trinary: more than
/// `occupied_thresh` is occupied, less than `free_thresh` is free, else it is unknown; where the image has an alpha, it counts as one
/// more colour. Mode scale: the same without alpha, but what lies between is graded linearly from 0 to 1, and a pixel that is not opaque
/// is unknown. Mode raw: the shade itself, 0 … 255 and whatever `negate` says, is a percentage of occupancy, above 100 unknown.
/// Throws InputError, for a yaw of the origin other than 0 too.
OccupancyMap read_occupancy_map(const std::filesystem::path& yaml_file);

/// Writes NAME.yaml and NAME.pgm, trinary: free 254, occupied 0, unknown 205. `name` has no extension. Throws InputError.
void write_occupancy_map(const OccupancyMap& map, const std::filesystem::path& name);

}  // namespace alignability
