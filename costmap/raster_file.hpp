// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "costmap/grid.hpp"

namespace alignability {

/// Where a TIFF, which does not say so itself, lies in `map`.
struct RasterPlace {
  double resolution = 1.0;                           ///< side of a pixel [m], > 0
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();  ///< outer corner of the lower left pixel [m]
};

/// A file of one value a cell, of one of three kinds: with a place a TIFF of 32-bit floats, one page, its top row first; with a layer an
/// alignability map that has it; else a map_server map, its values the occupancy from 0 to 1, the unknown none.
struct RasterFile {
  std::filesystem::path file;
  std::optional<RasterPlace> place = {};
  std::string layer = {};
};

/// NaN where there is no value. Throws InputError.
Grid<float> read_raster(const RasterFile& raster);

}  // namespace alignability
