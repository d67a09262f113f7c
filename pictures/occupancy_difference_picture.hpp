// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "costmap/occupancy_difference.hpp"

namespace alignability {

struct DifferencePictureOptions {
  std::string title;  ///< none when empty
  std::string first = "the first map";
  std::string second = "the second map";
};

/// Draws how two maps agree, x to the right and y up: white where both are free, black where both are occupied, pale green where they
/// differ by no more than a cell, red where the first alone is occupied, blue where the second alone is, grey where one knows nothing.
/// Throws InputError when the file is not named .png, .svg or .pdf, or cannot be written.
void draw_occupancy_difference(const OccupancyDifference& difference, const DifferencePictureOptions& options,
                               const std::filesystem::path& file);

}  // namespace alignability
