// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "alignability/build_map.hpp"
#include "cli/log_options.hpp"
#include "cli/output_name.hpp"
#include "lidar/site.hpp"

namespace alignability::cli {

/// What `map` is asked for: a map from a scene, from a log, of two maps in one, or one of each of many sites.
struct MapCommandOptions {
  std::filesystem::path scene;
  SiteOptions reading;
  LogOptions log;
  std::vector<std::filesystem::path> merge;  ///< none or two
  std::filesystem::path sites;
  std::optional<std::filesystem::path> occupancy;
  std::optional<std::filesystem::path> sensor;
  MapOptions map;
  std::optional<int> headings;  ///< none: as many as the sensor needs
  std::vector<int> cells;
  std::vector<double> polygon;
  std::optional<std::filesystem::path> update;
  bool json = false;
  std::filesystem::path output;
  PictureKinds pictures;
};

// Each makes the map, stores it under the name of the output, tells of it, and returns the exit code. Those that simulate scans share the
// work with the other processes of a job.
int map_from_scene(const MapCommandOptions& options);
int map_from_sites(const MapCommandOptions& options);
int map_from_log(const MapCommandOptions& options);
int map_from_two(const MapCommandOptions& options);

}  // namespace alignability::cli
