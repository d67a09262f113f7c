// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string_view>

#include "lidar/point_cloud.hpp"

namespace alignability::detail {

/// Reads the `vertex` element of the bytes of a PLY file, version 1.0, of any format. `file` is the name that errors show.
PointCloud parse_ply(std::string_view bytes, const std::filesystem::path& file);

/// Whether a PLY file is a mesh: its header, of which `bytes` hold at least the whole, declares faces or strips of triangles.
bool declares_faces(std::string_view bytes, const std::filesystem::path& file);

/// Throws InputError where the header of a PLY file is wrong, or declares more elements than the file has bytes.
void check_ply_header(std::string_view bytes, const std::filesystem::path& file);

}  // namespace alignability::detail
