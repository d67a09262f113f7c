// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "costmap/grid.hpp"

namespace alignability::detail {

/// What stands before the bytes of a grid, the top row first.
std::string pgm_header(const GridGeometry& geometry);

/// The YAML beside it.
std::string map_yaml(const GridGeometry& geometry, const std::filesystem::path& image, std::string_view mode,
                     std::string_view occupied_thresh, std::string_view free_thresh);

}  // namespace alignability::detail
