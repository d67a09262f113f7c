// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "lidar/triangle_mesh.hpp"

namespace alignability {

/// The axis of a file's coordinates that becomes z of `map`.
enum class UpAxis { x, y, z };

/// Turns coordinates whose `up` points up so that z does.
Eigen::Matrix3d to_z_up(UpAxis up);

struct MeshOptions {
  /// Metres a unit of the file; by default what the file says (COLLADA's `unit`), and metres where it says nothing.
  std::optional<double> unit;
  /// By default what the file or its format says (COLLADA's `up_axis`, y for glTF), and z where it says nothing.
  std::optional<UpAxis> up_axis;
  /// Reads only the mesh, or the node, of this name.
  std::optional<std::string> submesh;
};

/// Whether `read_mesh_file` reads files with this file's extension: .dae, .stl, .obj, .ply, .gltf or .glb, in any case.
bool is_mesh_file(const std::filesystem::path& file);

/// One mesh a node that has triangles, in the order of the file. Materials, textures and animations are ignored. Throws InputError naming
/// the file when it cannot be read, holds no triangles, is larger than 1 GiB or has more than 2^25 triangles.
std::vector<TriangleMesh> read_mesh_file(const std::filesystem::path& file, const MeshOptions& options = {});

}  // namespace alignability
