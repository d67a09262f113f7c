// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "lidar/scene.hpp"
#include "lidar/site.hpp"

namespace alignability::python {

/// A site, and what was left out of it or looked odd.
struct LoadedScene {
  Scene scene;
  std::vector<std::string> warnings = {};
};

/// A scene, or the file to read it from.
using SceneOrFile = std::variant<std::filesystem::path, Scene>;

/// Touches nothing of Python. Throws InputError.
LoadedScene load_scene(const std::filesystem::path& file, const SiteOptions& options);
LoadedScene load_scene(const SceneOrFile& scene);

/// As Python warns. Throws what the user's filters make of a warning.
void warn(const std::vector<std::string>& warnings);

}  // namespace alignability::python
