// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string_view>

#include "lidar/point_cloud.hpp"

namespace alignability::detail {

/// The points of a file with the normals that it has, and how they are ordered.
struct OrderedCloud {
  PointCloud cloud;
  int rings = 1;
  int columns = 0;
};

/// Reads the bytes of a PCD file, version 0.7: ascii, binary or binary_compressed. `file` is the name that errors show.
OrderedCloud parse_pcd(std::string_view bytes, const std::filesystem::path& file);

}  // namespace alignability::detail
