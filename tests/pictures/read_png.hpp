// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cairomm/cairomm.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <ostream>

#include "pictures/colour.hpp"

namespace alignability {

inline void PrintTo(const Colour& colour, std::ostream* out) {
  *out << "(" << colour.red << " " << colour.green << " " << colour.blue << ")";
}

}  // namespace alignability

namespace alignability::test {

/// A picture read back from its file.
class Picture {
 public:
  explicit Picture(const std::filesystem::path& png) : surface_(Cairo::ImageSurface::create_from_png(png.string())) {}

  int width() const { return surface_->get_width(); }
  int height() const { return surface_->get_height(); }
  /// The pixel that holds a point of the page.
  Colour at(const Eigen::Vector2d& point) const {
    const auto column = static_cast<std::size_t>(std::floor(point.x()));
    const auto row = static_cast<std::size_t>(std::floor(point.y()));
    const unsigned char* line = surface_->get_data() + row * static_cast<std::size_t>(surface_->get_stride());
    return colour_from_hex(reinterpret_cast<const std::uint32_t*>(line)[column] & 0xffffffu);
  }
  int count(const Colour& colour) const {
    int found = 0;
    for (int row = 0; row < height(); ++row) {
      for (int column = 0; column < width(); ++column) found += at(Eigen::Vector2d(column, row)) == colour ? 1 : 0;
    }
    return found;
  }

 private:
  Cairo::RefPtr<Cairo::ImageSurface> surface_;
};

/// The largest difference of a part; a picture's parts are whole 255ths.
inline double difference(const Colour& a, const Colour& b) {
  return std::max({std::abs(a.red - b.red), std::abs(a.green - b.green), std::abs(a.blue - b.blue)});
}
inline constexpr double kRounding = 1.0 / 255.0;

}  // namespace alignability::test
