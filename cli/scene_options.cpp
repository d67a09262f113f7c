// SPDX-License-Identifier: BSD-3-Clause
#include "cli/scene_options.hpp"

#include <iostream>

namespace alignability::cli {

void add_world_options(CLI::App& command, WorldOptions& options) {
  command.add_option("--model-path", options.model_paths, "Folder to look for models in; may be given more than once");
  const std::map<std::string, SdfGeometry> names{{"visual", SdfGeometry::visual}, {"collision", SdfGeometry::collision}};
  command.add_option("--geometry", options.geometry, "Which geometry of a world: collision (default) or visual")
      ->transform(CLI::CheckedTransformer(names).description(""))
      ->option_text("visual|collision");
}

std::vector<TriangleMesh> read_meshes(const std::filesystem::path& world, const WorldOptions& options) {
  World read = read_site(world, options);
  for (const std::string& warning : read.warnings) std::cerr << "warning: " << warning << '\n';
  return std::move(read.meshes);
}

}  // namespace alignability::cli
