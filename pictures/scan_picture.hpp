// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace alignability {

struct ScanPictureOptions {
  std::string title;               ///< none when empty
  std::vector<std::string> lines;  ///< figures to write beside the scan: "α = 0.42"
  /// An axis in the `lidar` frame, drawn as it looks from above; its length need not be 1 and its sign means nothing.
  std::optional<Eigen::Vector3d> weakest_direction;
  /// Half the side of the square that is shown [m]; without it all returns are.
  std::optional<double> range;
};

/// Draws a scan from above in its own frame: x, forward, to the right; y, left, up; the sensor in the middle. Points take the colour of
/// their plane, given by number from 0, -1 = none; those that are not finite are passed over.
/// Throws std::invalid_argument unless there is one plane per point and `range` is positive, InputError when the file cannot be written.
void draw_scan(std::span<const Eigen::Vector3f> points, std::span<const int> plane_of_point, const ScanPictureOptions& options,
               const std::filesystem::path& png);

}  // namespace alignability
