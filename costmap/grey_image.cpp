// SPDX-License-Identifier: BSD-3-Clause
#include "costmap/grey_image.hpp"

#include <png.h>

#include <algorithm>
#include <string>

#include "core/file.hpp"
#include "core/input_error.hpp"
#include "costmap/pnm.hpp"

namespace alignability::detail {
namespace {

constexpr std::uintmax_t kLargestFile = std::uintmax_t{2} << 30;
constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 29;

void check_size(const std::filesystem::path& file, std::uint64_t width, std::uint64_t height, std::uint64_t most) {
  if (width == 0 || height == 0) throw InputError(file, "has no pixels");
  if (width > kMostPixels || height > kMostPixels || width * height > std::min(most, kMostPixels)) {
    throw InputError(
        file, "says that it is " + std::to_string(width) + " × " + std::to_string(height) + " pixels, more than it can hold or we read");
  }
}

GreyImage read_png(const std::filesystem::path& file, const std::string& bytes) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) == 0)
    throw InputError(file, std::string("not a PNG: ") + png.message);
  // A row of equal pixels takes a thousandth of its size in a PNG, not less.
  constexpr std::uint64_t kMostPixelsPerByte = 8 * 1100;
  try {
    check_size(file, png.width, png.height, bytes.size() * kMostPixelsPerByte);
  } catch (...) {
    png_image_free(&png);
    throw;
  }
  const bool has_alpha = (png.format & PNG_FORMAT_FLAG_ALPHA) != 0;
  png.format = PNG_FORMAT_RGBA;
  // Without it libpng takes 16-bit values for linear light and brightens them.
  png.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;
  GreyImage image{static_cast<int>(png.width), static_cast<int>(png.height), std::vector<std::uint8_t>(PNG_IMAGE_SIZE(png)), has_alpha};
  if (png_image_finish_read(&png, nullptr, image.rgba.data(), 0, nullptr) == 0)
    throw InputError(file, std::string("damaged PNG: ") + png.message);
  return image;
}

GreyImage read_pnm(const std::filesystem::path& file, const std::string& bytes) {
  try {
    const PnmHeader header = read_pnm_header(bytes);
    check_size(file, header.width, header.height, 8 * bytes.size());
    if (header.brightest > 255) throw InputError(file, "has " + std::to_string(header.brightest) + " for white; at most 255 is read");
    return decode_pnm(bytes);
  } catch (const PnmError& error) {
    throw InputError(file, std::string("damaged PNM: ") + error.what());
  }
}

}  // namespace

GreyImage read_grey_image(const std::filesystem::path& file) {
  const std::string bytes = read_file(file, kLargestFile);
  if (bytes.starts_with("\x89PNG")) return read_png(file, bytes);
  if (bytes.size() > 2 && bytes[0] == 'P' && bytes[1] >= '1' && bytes[1] <= '6') return read_pnm(file, bytes);
  throw InputError(file, "is neither a PNG nor a PGM, PPM or PBM");
}

}  // namespace alignability::detail
