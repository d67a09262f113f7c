// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "lidar/disc_cloud.hpp"
#include "lidar/mesh_file.hpp"
#include "lidar/sdf_world.hpp"
#include "lidar/triangle_mesh.hpp"

namespace alignability {

struct SiteOptions {
  WorldOptions world;
  /// Metres a unit of a mesh or cloud, as MeshOptions has it; a cloud says nothing of its unit.
  std::optional<double> unit;
  /// Of a mesh or cloud, likewise.
  std::optional<UpAxis> up_axis;
  /// Turns and lifts a cloud so that its floor lies level at z = 0 (see `leveled`); else it stays as it is.
  bool level = false;
  /// How a cloud becomes surfaces.
  DiscOptions discs;
};

/// What a robot drives and looks about in: triangles, or discs where it is known by points.
struct Site {
  std::vector<TriangleMesh> meshes = {};
  DiscCloud discs = {};
  /// What leveling did to a cloud, after unit and up axis.
  Eigen::Isometry3d T_map_file = Eigen::Isometry3d::Identity();
  /// What was left out or looked odd, one sentence each.
  std::vector<std::string> warnings = {};
};

/// Reads an SDF world or model, a mesh file or a point cloud, told apart by content: a PLY with faces is a mesh, one without a cloud. Where
/// content tells nothing (OBJ, STL, BIN) the extension does. Throws InputError when a file cannot be read as what it is, is none of these,
/// or options are given that are another kind's, and for a cloud with coordinates beyond 100 km, where floats are coarser than centimetres.
Site read_site(const std::filesystem::path& file, const SiteOptions& options = {});

}  // namespace alignability
