// SPDX-License-Identifier: BSD-3-Clause
#include "costmap/grey_image.hpp"

#include <png.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <new>
#include <string>
#include <string_view>

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

// Reads the bytes of a PNG through libpng, whose faults come as calls that must not return: they throw.
class PngReader {
 public:
  PngReader(const std::filesystem::path& file, std::string_view bytes) : file_(file), rest_(bytes) {
    if (png_ == nullptr || info_ == nullptr) throw std::bad_alloc();
    png_set_read_fn(png_, this, read_bytes);
  }
  ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  GreyImage read() {
    // A row of equal pixels takes a thousandth of its size in a PNG, not less.
    const std::uint64_t most_pixels = rest_.size() * 8 * 1100;
    png_read_info(png_, info_);
    const png_uint_32 width = png_get_image_width(png_, info_);
    const png_uint_32 height = png_get_image_height(png_, info_);
    check_size(file_, width, height, most_pixels);
    const bool has_alpha = (png_get_color_type(png_, info_) & PNG_COLOR_MASK_ALPHA) != 0 || png_get_valid(png_, info_, PNG_INFO_tRNS) != 0;
    widen_to_rgba();
    const std::size_t values = 4 * std::size_t{width} * std::size_t{height};
    GreyImage image{static_cast<int>(width), static_cast<int>(height), std::vector<std::uint16_t>(values), has_alpha};
    std::vector<png_bytep> rows;
    for (std::size_t i = 0; i < values; i += 4 * std::size_t{width}) rows.push_back(reinterpret_cast<png_bytep>(&image.rgba[i]));
    png_read_image(png_, rows.data());
    png_read_end(png_, nullptr);
    return image;
  }

 private:
  void widen_to_rgba() {
    png_set_expand_16(png_);
    png_set_gray_to_rgb(png_);
    png_set_add_alpha(png_, GreyImage::kFull, PNG_FILLER_AFTER);
    if constexpr (std::endian::native == std::endian::little) png_set_swap(png_);
    png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
  }

  [[noreturn]] static void fail(png_structp png, png_const_charp message) {
    const auto* reader = static_cast<const PngReader*>(png_get_error_ptr(png));
    throw InputError(reader->file_, std::string("damaged PNG: ") + message);
  }
  static void ignore(png_structp, png_const_charp) {}
  static void read_bytes(png_structp png, png_bytep to, std::size_t count) {
    auto* reader = static_cast<PngReader*>(png_get_io_ptr(png));
    if (count > reader->rest_.size()) png_error(png, "it ends early");
    std::memcpy(to, reader->rest_.data(), count);
    reader->rest_.remove_prefix(count);
  }

  const std::filesystem::path& file_;
  std::string_view rest_;
  png_structp png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, fail, ignore);
  png_infop info_ = png_create_info_struct(png_);
};

GreyImage read_pnm(const std::filesystem::path& file, const std::string& bytes) {
  const PnmHeader header = read_pnm_header(bytes, file);
  check_size(file, header.width, header.height, 8 * bytes.size());
  return decode_pnm(bytes, file);
}

}  // namespace

GreyImage read_grey_image(const std::filesystem::path& file) {
  const std::string bytes = read_file(file, kLargestFile);
  if (bytes.starts_with("\x89PNG")) return PngReader(file, bytes).read();
  if (bytes.size() > 2 && bytes[0] == 'P' && bytes[1] >= '1' && bytes[1] <= '6') return read_pnm(file, bytes);
  throw InputError(file, "is neither a PNG nor a PGM, PPM or PBM");
}

}  // namespace alignability::detail
