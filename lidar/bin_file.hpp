// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string_view>
#include <vector>

namespace alignability::detail {

/// Whether a file has the extension .bin, in any case: what KITTI and Velodyne tools write bears no other mark.
bool is_bin_file(const std::filesystem::path& file);

/// Reads the bytes of a KITTI or Velodyne file: x, y, z and intensity as little-endian floats, point after point, and no header. Bytes that
/// are no points show in coordinates that no lidar measures. `file` is the name that errors show.
std::vector<Eigen::Vector3f> parse_bin(std::string_view bytes, const std::filesystem::path& file);

}  // namespace alignability::detail
