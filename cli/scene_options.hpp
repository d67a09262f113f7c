// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>

#include "lidar/scene.hpp"
#include "lidar/site.hpp"

namespace alignability::cli {

/// What a site may be, as the help of every command that reads one says.
inline constexpr const char* kSiteHelp = "SDF world or model, mesh, or point cloud";

/// How a site is read, for every command that reads one.
void add_site_options(CLI::App& command, SiteOptions& options);

/// Reads a site and tells on stderr its warnings and how dense a cloud is.
Site read_site_telling(const std::filesystem::path& file, const SiteOptions& options);

/// Likewise, to trace rays in.
Scene read_scene(const std::filesystem::path& file, const SiteOptions& options);

/// The same without a word.
Scene read_scene_quietly(const std::filesystem::path& file, const SiteOptions& options);

}  // namespace alignability::cli
