// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <numeric>
#include <vector>

namespace alignability::detail {

/// An image as map_server sees it. Row 0 is the top one.
struct GreyImage {
  int width = 0;
  int height = 0;
  std::vector<std::uint16_t> rgba;  ///< four values a pixel, each from 0 to 65535, as nav2's GraphicsMagick holds them
  bool has_alpha = false;           ///< whether the file says how opaque its pixels are

  /// The mean of the colours, from 0 black to 1 white.
  double shade(int x, int row) const { return mean_of(3, pixel(x, row)); }
  /// The mean of the colours and, where there is one, of the alpha.
  double shade_with_alpha(int x, int row) const { return mean_of(has_alpha ? 4 : 3, pixel(x, row)); }
  bool opaque(int x, int row) const { return pixel(x, row)[3] == kFull; }

  static constexpr std::uint16_t kFull = 65535;

 private:
  const std::uint16_t* pixel(int x, int row) const {
    return &rgba[4 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x))];
  }
  static double mean_of(int channels, const std::uint16_t* first) {
    return static_cast<double>(std::accumulate(first, first + channels, 0)) / channels / kFull;
  }
};

/// A PNG, or a PNM of any kind (PGM, PPM, PBM; text or binary), told apart by content. Throws InputError.
GreyImage read_grey_image(const std::filesystem::path& file);

}  // namespace alignability::detail
