// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace alignability::detail {

/// How bright a pixel is, in whole numbers so that 51 of 255 meets a threshold of 0.2.
struct Shade {
  int light = 0;  ///< 0 black … `white`
  int white = 255;
  bool opaque = true;
};

/// An image as map_server sees it. Row 0 is the top one.
struct GreyImage {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;  ///< four bytes a pixel
  bool has_alpha = false;          ///< whether the file says how opaque its pixels are

  /// The mean of the colours.
  Shade shade(int x, int row) const {
    const std::uint8_t* channel = pixel(x, row);
    return {channel[0] + channel[1] + channel[2], 3 * 255, channel[3] == 255};
  }
  /// The mean of the colours and, where there is one, of the alpha.
  Shade shade_with_alpha(int x, int row) const {
    const std::uint8_t* channel = pixel(x, row);
    return has_alpha ? Shade{channel[0] + channel[1] + channel[2] + channel[3], 4 * 255, channel[3] == 255} : shade(x, row);
  }

  const std::uint8_t* pixel(int x, int row) const {
    return &rgba[4 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x))];
  }
};

/// A PNG, or a PNM of any kind (PGM, PPM, PBM; text or binary), told apart by content. Throws InputError.
GreyImage read_grey_image(const std::filesystem::path& file);

}  // namespace alignability::detail
