// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "planner/route.hpp"

namespace alignability {

/// What a LIF file may leave to choose. Of other files nothing may be chosen.
struct RouteFileOptions {
  std::optional<std::string> vehicle;  ///< a vehicleTypeId, or "manufacturer.seriesName"; needed where vehicles drive an edge differently
  std::optional<std::string> map;      ///< a mapId; needed where nodes lie on several maps
};

/// Reads ways in `map`, metres and radians, by the file's extension:
/// - .csv, .txt: a path, a place a line; columns named x, y and, if there is one, yaw, whatever others there are; or without names two or
///   three numbers a line. Apart by commas, semicolons, tabs or blanks; lines that begin with # and empty ones count for nothing. Without
///   yaw the robot looks where it goes and turns on the spot.
/// - .geojson, .json: a graph of nav2's route server. An edge is straight whatever its geometry, as nav2 drives it.
/// - .lif, .json: a layout in VDMA's LIF 1.0 or 2.0. Of an edge, nodes, trajectory and orientation are read; curves to 1 mm.
/// Throws InputError, for options that do not apply too.
Route read_route(const std::filesystem::path& file, const RouteFileOptions& options);

}  // namespace alignability
