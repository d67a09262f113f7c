// SPDX-License-Identifier: BSD-3-Clause
#include "cli/scene_options.hpp"

#include <iostream>

#include "core/input_error.hpp"

namespace alignability::cli {
namespace {

SdfGeometry geometry_named(const std::string& name) {
  if (name == "visual") return SdfGeometry::visual;
  if (name == "collision") return SdfGeometry::collision;
  const std::vector<std::string> names{"visual", "collision"};
  throw CLI::ValidationError("--geometry", "must be visual or collision, not " + name + did_you_mean(name, names));
}

}  // namespace

void add_world_options(CLI::App& command, WorldOptions& options) {
  command.add_option("--model-path", options.model_paths, "Folder to look for models in; may be given more than once")
      ->check(CLI::ExistingDirectory)
      ->option_text("FOLDER");
  command
      .add_option_function<std::string>(
          "--geometry", [&options](const std::string& name) { options.geometry = geometry_named(name); },
          "Which geometry of a world: collision (default) or visual")
      ->option_text("visual|collision");
}

std::vector<TriangleMesh> read_meshes(const std::filesystem::path& world, const WorldOptions& options) {
  World read = read_site(world, options);
  for (const std::string& warning : read.warnings) std::cerr << "warning: " << warning << '\n';
  return std::move(read.meshes);
}

}  // namespace alignability::cli
