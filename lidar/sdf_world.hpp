// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lidar/triangle_mesh.hpp"

namespace alignability {

enum class SdfGeometry { visual, collision };

struct WorldOptions {
  /// Folders to look for models in, besides those named at `read_world`.
  std::vector<std::filesystem::path> model_paths;
  SdfGeometry geometry = SdfGeometry::collision;
};

struct World {
  /// One a visual or collision, named `model::link::collision`.
  std::vector<TriangleMesh> meshes;
  /// What was left out or looked odd, one sentence each, with file and line where there is one.
  std::vector<std::string> warnings;
};

/// Reads an SDF world or a lone model. A `model://` URI is looked for in the folder of the file, in `models` in it and beside it, in
/// `options.model_paths`, then in the folders that the environment names in GAZEBO_MODEL_PATH, SDF_PATH and GZ_SIM_RESOURCE_PATH. Units of
/// meshes are honoured, COLLADA's up axis is not, as in Gazebo. A plane among the collisions has no end by SDF's definition: it is cut to
/// the square around the plane's origin that reaches 10 m beyond everything else. Geometry that cannot be read (height maps, polylines,
/// images) becomes a warning; a missing model or mesh is an InputError at the line that names it.
World read_world(const std::filesystem::path& file, const WorldOptions& options = {});

}  // namespace alignability
