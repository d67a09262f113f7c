// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace alignability {

/// An sRGB colour, each part in [0,1].
struct Colour {
  double red = 0.0;
  double green = 0.0;
  double blue = 0.0;

  bool operator==(const Colour&) const = default;
};

/// From 0xRRGGBB.
inline constexpr Colour colour_from_hex(unsigned hex) {
  return {((hex >> 16) & 0xffu) / 255.0, ((hex >> 8) & 0xffu) / 255.0, (hex & 0xffu) / 255.0};
}

}  // namespace alignability
