// SPDX-License-Identifier: BSD-3-Clause
#include "costmap/float_tiff.hpp"

#include <tiffio.h>

#include <cstdarg>
#include <cstdio>
#include <memory>
#include <string>

#include "core/file.hpp"
#include "core/input_error.hpp"

namespace alignability::detail {
namespace {

constexpr std::uint32_t kGdalNoData = 42113;
constexpr std::uintmax_t kLargestTiff = std::uintmax_t{16} << 30;

// libtiff tells what is wrong through a handler that is given this text to fill.
int keep_message(TIFF*, void* message, const char*, const char* format, va_list arguments) {
  char buffer[512];
  std::vsnprintf(buffer, sizeof buffer, format, arguments);
  *static_cast<std::string*>(message) = buffer;
  return 1;
}

int ignore_message(TIFF*, void*, const char*, const char*, va_list) { return 1; }

// A TIFF open for reading or writing, and the last thing that libtiff said of it.
class Tiff {
 public:
  Tiff(const std::filesystem::path& opened, const char* mode, std::filesystem::path shown) : shown_(std::move(shown)) {
    const std::unique_ptr<TIFFOpenOptions, void (*)(TIFFOpenOptions*)> options(TIFFOpenOptionsAlloc(), TIFFOpenOptionsFree);
    TIFFOpenOptionsSetErrorHandlerExtR(options.get(), keep_message, &message_);
    TIFFOpenOptionsSetWarningHandlerExtR(options.get(), ignore_message, nullptr);
    tiff_.reset(TIFFOpenExt(opened.c_str(), mode, options.get()));
    if (!tiff_) fail("not a TIFF");
  }

  TIFF* get() const { return tiff_.get(); }
  void check(bool ok, const char* what) const {
    if (!ok) fail(what);
  }
  [[noreturn]] void fail(const std::string& what) const { throw InputError(shown_, message_.empty() ? what : what + ": " + message_); }

 private:
  struct Close {
    void operator()(TIFF* tiff) const { TIFFClose(tiff); }
  };

  std::filesystem::path shown_;
  std::string message_;
  std::unique_ptr<TIFF, Close> tiff_;
};

Grid<float> read_page(const Tiff& tiff, const GridGeometry& geometry) {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint16_t bits = 0;
  std::uint16_t format = 0;
  std::uint16_t samples = 0;
  TIFFGetField(tiff.get(), TIFFTAG_IMAGEWIDTH, &width);
  TIFFGetField(tiff.get(), TIFFTAG_IMAGELENGTH, &height);
  TIFFGetFieldDefaulted(tiff.get(), TIFFTAG_BITSPERSAMPLE, &bits);
  TIFFGetFieldDefaulted(tiff.get(), TIFFTAG_SAMPLEFORMAT, &format);
  TIFFGetFieldDefaulted(tiff.get(), TIFFTAG_SAMPLESPERPIXEL, &samples);
  if (bits != 32 || format != SAMPLEFORMAT_IEEEFP || samples != 1 || TIFFIsTiled(tiff.get())) {
    tiff.fail("must hold rows of one 32-bit float a pixel");
  }
  if (width != static_cast<std::uint32_t>(geometry.width) || height != static_cast<std::uint32_t>(geometry.height)) {
    tiff.fail("is " + std::to_string(width) + " × " + std::to_string(height) + " pixels where the map has " +
              std::to_string(geometry.width) + " × " + std::to_string(geometry.height) + " cells");
  }
  tiff.check(TIFFScanlineSize64(tiff.get()) == std::uint64_t{width} * sizeof(float), "has rows of an unexpected length");
  std::vector<float> row(width);
  Grid<float> page(geometry, 0.0f);
  // From the first line on: libtiff goes back by unpacking a strip anew.
  for (int line = 0; line < geometry.height; ++line) {
    tiff.check(TIFFReadScanline(tiff.get(), row.data(), static_cast<std::uint32_t>(line)) == 1, "is damaged");
    std::copy(row.begin(), row.end(), &page[Cell{0, geometry.height - 1 - line}]);
  }
  return page;
}

// libtiff forgets the tags it was taught with every page.
void mark_nan_as_no_data(const Tiff& tiff) {
  static const TIFFFieldInfo field{kGdalNoData, -1, -1, TIFF_ASCII, FIELD_CUSTOM, 1, 0, const_cast<char*>("GDAL_NODATA")};
  TIFFMergeFieldInfo(tiff.get(), &field, 1);
  TIFFSetField(tiff.get(), kGdalNoData, "nan");
}

void write_page(const Tiff& tiff, const AlignabilityMap::Layer& layer) {
  const GridGeometry& geometry = layer.values.geometry();
  TIFFSetField(tiff.get(), TIFFTAG_IMAGEWIDTH, static_cast<std::uint32_t>(geometry.width));
  TIFFSetField(tiff.get(), TIFFTAG_IMAGELENGTH, static_cast<std::uint32_t>(geometry.height));
  TIFFSetField(tiff.get(), TIFFTAG_BITSPERSAMPLE, 32);
  TIFFSetField(tiff.get(), TIFFTAG_SAMPLESPERPIXEL, 1);
  TIFFSetField(tiff.get(), TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_IEEEFP);
  TIFFSetField(tiff.get(), TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
  TIFFSetField(tiff.get(), TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
  TIFFSetField(tiff.get(), TIFFTAG_COMPRESSION, COMPRESSION_ADOBE_DEFLATE);
  TIFFSetField(tiff.get(), TIFFTAG_PREDICTOR, PREDICTOR_FLOATINGPOINT);
  TIFFSetField(tiff.get(), TIFFTAG_ROWSPERSTRIP, TIFFDefaultStripSize(tiff.get(), 0));
  TIFFSetField(tiff.get(), TIFFTAG_PAGENAME, layer.name.c_str());
  mark_nan_as_no_data(tiff);
  std::vector<float> row(static_cast<std::size_t>(geometry.width));
  for (int y = 0; y < geometry.height; ++y) {
    const float* first = &layer.values[Cell{0, geometry.height - 1 - y}];
    std::copy(first, first + geometry.width, row.begin());
    tiff.check(TIFFWriteScanline(tiff.get(), row.data(), static_cast<std::uint32_t>(y)) == 1, "cannot be written");
  }
  tiff.check(TIFFWriteDirectory(tiff.get()) == 1, "cannot be written");
}

}  // namespace

std::vector<Grid<float>> read_float_tiff(const std::filesystem::path& file, const GridGeometry& geometry, std::size_t most) {
  std::error_code error;
  const std::uintmax_t length = std::filesystem::file_size(file, error);
  if (error) throw InputError(file, "cannot be read: " + error.message());
  // Deflate shrinks at most about a thousandfold: a file shorter than that cannot hold the map, whatever its header says.
  constexpr std::uintmax_t kMostShrunk = 1100;
  if (length > kLargestTiff || geometry.size() * sizeof(float) > length * kMostShrunk) {
    throw InputError(file, "is " + std::to_string(length) + " bytes long, which cannot hold " + std::to_string(geometry.size()) + " cells");
  }
  const Tiff tiff(file, "r", file);
  std::vector<Grid<float>> pages;
  do {
    if (pages.size() == most) tiff.fail("has more pages than the map has layers, " + std::to_string(most));
    pages.push_back(read_page(tiff, geometry));
  } while (TIFFReadDirectory(tiff.get()) == 1);
  return pages;
}

GridGeometry pixels_of_tiff(const std::filesystem::path& file) {
  constexpr std::uint32_t kLargestSide = 1u << 20;
  const Tiff tiff(file, "r", file);
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  TIFFGetField(tiff.get(), TIFFTAG_IMAGEWIDTH, &width);
  TIFFGetField(tiff.get(), TIFFTAG_IMAGELENGTH, &height);
  if (width == 0 || height == 0 || width > kLargestSide || height > kLargestSide) {
    tiff.fail("must have from 1 to " + std::to_string(kLargestSide) + " pixels along a side");
  }
  return {.width = static_cast<int>(width), .height = static_cast<int>(height)};
}

void write_float_tiff(const std::filesystem::path& file, std::span<const AlignabilityMap::Layer> layers) {
  AtomicFile output(file);
  {
    const Tiff tiff(output.temporary(), "w", file);
    for (const AlignabilityMap::Layer& layer : layers) write_page(tiff, layer);
  }
  output.commit();
}

}  // namespace alignability::detail
