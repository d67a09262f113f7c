// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lidar/triangle_mesh.hpp"

namespace alignability::detail {

/// Meshes as bytes, for a process on the same machine.
std::string bytes_of(const std::vector<TriangleMesh>& meshes);
/// What `bytes_of` made bytes of.
std::vector<TriangleMesh> meshes_of(std::string_view bytes);

}  // namespace alignability::detail
