// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <vector>

#include "lidar/sdf_world.hpp"

namespace alignability::cli {

/// How a world is read, for every command that reads one.
void add_world_options(CLI::App& command, WorldOptions& options);

/// Reads a world and tells its warnings on stderr.
std::vector<TriangleMesh> read_meshes(const std::filesystem::path& world, const WorldOptions& options);

}  // namespace alignability::cli
