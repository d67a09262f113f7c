// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "costmap/alignability_map.hpp"

namespace alignability::detail {

/// The pages of a TIFF of one 32-bit float a pixel, flipped so that row 0 is the bottom one. Throws InputError unless every page has
/// the size of `geometry`, and for more than `most` pages.
std::vector<Grid<float>> read_float_tiff(const std::filesystem::path& file, const GridGeometry& geometry, std::size_t most);

/// How many pixels its first page has: the width and height of a grid whose cells are 1 wide. Throws InputError for none, and more than
/// 2^20 along a side.
GridGeometry pixels_of_tiff(const std::filesystem::path& file);

void write_float_tiff(const std::filesystem::path& file, std::span<const AlignabilityMap::Layer> layers);

}  // namespace alignability::detail
