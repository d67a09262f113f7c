// SPDX-License-Identifier: BSD-3-Clause
#include "tests/costmap/images.hpp"

#include <png.h>

#include <cstdio>
#include <memory>

namespace alignability::test {

void write_png(const std::filesystem::path& file, PngKind kind, int width, const std::vector<int>& values, double gamma) {
  const int channels = kind == PngKind::rgb ? 3 : kind == PngKind::rgba ? 4 : kind == PngKind::grey_alpha ? 2 : 1;
  const int colour = kind == PngKind::rgb          ? PNG_COLOR_TYPE_RGB
                     : kind == PngKind::rgba       ? PNG_COLOR_TYPE_RGB_ALPHA
                     : kind == PngKind::grey_alpha ? PNG_COLOR_TYPE_GRAY_ALPHA
                                                   : PNG_COLOR_TYPE_GRAY;
  const int height = static_cast<int>(values.size()) / (width * channels);
  std::vector<png_byte> bytes;
  for (const int value : values) {
    if (kind == PngKind::grey16) bytes.push_back(static_cast<png_byte>(value >> 8));
    bytes.push_back(static_cast<png_byte>(value & 255));
  }
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(std::fopen(file.c_str(), "wb"), std::fclose);
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_init_io(png, stream.get());
  png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), kind == PngKind::grey16 ? 16 : 8, colour,
               PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (gamma > 0.0) png_set_gAMA(png, info, gamma);
  const png_color_16 transparent{.index = 0, .red = 0, .green = 0, .blue = 0, .gray = kTransparentShade};
  if (kind == PngKind::grey_keyed) png_set_tRNS(png, info, nullptr, 0, &transparent);
  png_write_info(png, info);
  const std::size_t stride = bytes.size() / static_cast<std::size_t>(height);
  for (std::size_t row = 0; row < static_cast<std::size_t>(height); ++row) png_write_row(png, &bytes[row * stride]);
  png_write_end(png, nullptr);
  png_destroy_write_struct(&png, &info);
}

std::string pgm(int width, const std::vector<int>& shades) {
  std::string bytes = "P5\n" + std::to_string(width) + ' ' + std::to_string(static_cast<int>(shades.size()) / width) + "\n255\n";
  for (const int shade : shades) bytes += static_cast<char>(shade);
  return bytes;
}

}  // namespace alignability::test
