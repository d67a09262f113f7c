// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "alignability/build_map.hpp"
#include "lidar/site.hpp"

namespace alignability {

/// A site of which a map is to be built, and how.
struct MapSite {
  std::string name;
  std::filesystem::path output;  ///< of the map's files, without an extension
  std::filesystem::path scene;
  std::filesystem::path occupancy;
  std::filesystem::path sensor;
  SiteOptions reading = {};
  MapOptions map = {};
  std::optional<int> headings = {};  ///< none: as many as the sensor needs
};

/// Reads sites, and above them what holds for each that does not say otherwise, every key but `sites` and `name` optional in either place:
///
///     sensor: sensors/hdl32e.yaml
///     range_max: 20
///     sites:
///       - {name: hall, scene: hall.sdf, occupancy: hall_occupancy.yaml}
///       - {name: yard, scene: yard.pcd, occupancy: yard_occupancy.yaml, level: true, resolution: 2, output: maps/yard}
///
/// A site has a scene, an occupancy map and a sensor in the end; its output is its name unless it says so. Keys are the options of
/// `alignability map`, with `_` for `-`. Throws InputError at the key that is wrong, for a name or an output that two sites have, and for
/// an output that an input would be lost by.
std::vector<MapSite> read_sites_file(const std::filesystem::path& yaml_file);

}  // namespace alignability
