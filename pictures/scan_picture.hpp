// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "costmap/occupancy_map.hpp"

namespace alignability {

struct ScanPictureOptions {
  std::string title;               ///< none when empty
  std::vector<std::string> lines;  ///< figures to write beside the scan: "α = 0.42"
  /// An axis in the `lidar` frame, drawn as it looks from above; its length need not be 1 and its sign means nothing.
  std::optional<Eigen::Vector3d> weakest_direction;
  /// Half the side of the square that is shown [m]; without it all returns are.
  std::optional<double> range;
  /// Where the sensor stood: then the scan is drawn in `map` in place of its own frame.
  std::optional<Eigen::Isometry3d> T_map_lidar = {};
  const OccupancyMap* occupancy = nullptr;  ///< its walls are drawn beneath a scan that is drawn in `map`; not owned
  /// What the key says of the planes, in the order of their points, the most first; those without a label by number and points.
  std::vector<std::string> plane_labels = {};
  std::string smaller_planes = {};  ///< what the key says of those beyond `kNamedPlanes`; their number when empty
};

/// How many planes have a colour and a line of their own, the largest; the others share paler colours.
inline constexpr std::size_t kNamedPlanes = 12;

/// Draws a scan from above: in its own frame x, forward, is to the right and y, left, up; in `map` they are what they are there. The sensor
/// is in the middle. Points take the colour of their plane, given by number from 0, -1 = none; those that are not finite are passed over.
/// Throws std::invalid_argument unless there is one plane per point and `range` is positive, InputError when the file is not named .png,
/// .svg or .pdf, or cannot be written.
void draw_scan(std::span<const Eigen::Vector3f> points, std::span<const int> plane_of_point, const ScanPictureOptions& options,
               const std::filesystem::path& file);

}  // namespace alignability
