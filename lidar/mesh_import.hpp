// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "lidar/mesh_file.hpp"

namespace alignability::detail {

/// What assimp reads of a file. As Debian 12 has it, it crashes, hangs or fills memory on some damaged files: to be called where that does
/// no harm. Throws InputError, without a position.
std::vector<TriangleMesh> import_meshes(const std::filesystem::path& file, const MeshOptions& options);

/// Of a file's name, with the dot.
std::string lower_extension(const std::filesystem::path& file);

/// More are not read.
inline constexpr std::size_t kMostTriangles = std::size_t{1} << 25;

}  // namespace alignability::detail
