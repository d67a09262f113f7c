// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tiffio.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

namespace alignability::test {

struct TiffPage {
  int width = 1;
  int height = 1;
  int bits = 32;
  int format = SAMPLEFORMAT_IEEEFP;
  int samples = 1;
  int compression = COMPRESSION_NONE;
  bool tiled = false;
  float value = 0.5f;  ///< of every pixel of 32 bits
};

/// A TIFF as other programs might write it.
inline void write_tiff(const std::filesystem::path& file, const std::vector<TiffPage>& pages) {
  const std::unique_ptr<TIFF, void (*)(TIFF*)> tiff(TIFFOpen(file.c_str(), "w"), TIFFClose);
  for (const TiffPage& page : pages) {
    TIFFSetField(tiff.get(), TIFFTAG_IMAGEWIDTH, page.width);
    TIFFSetField(tiff.get(), TIFFTAG_IMAGELENGTH, page.height);
    TIFFSetField(tiff.get(), TIFFTAG_BITSPERSAMPLE, page.bits);
    TIFFSetField(tiff.get(), TIFFTAG_SAMPLEFORMAT, page.format);
    TIFFSetField(tiff.get(), TIFFTAG_SAMPLESPERPIXEL, page.samples);
    TIFFSetField(tiff.get(), TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    TIFFSetField(tiff.get(), TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
    TIFFSetField(tiff.get(), TIFFTAG_COMPRESSION, page.compression);
    std::vector<float> pixels(4096, page.value);
    if (page.tiled) {
      TIFFSetField(tiff.get(), TIFFTAG_TILEWIDTH, 16);
      TIFFSetField(tiff.get(), TIFFTAG_TILELENGTH, 16);
      TIFFWriteTile(tiff.get(), pixels.data(), 0, 0, 0, 0);
    } else {
      TIFFSetField(tiff.get(), TIFFTAG_ROWSPERSTRIP, page.height);
      for (int row = 0; row < page.height; ++row) TIFFWriteScanline(tiff.get(), pixels.data(), static_cast<std::uint32_t>(row));
    }
    TIFFWriteDirectory(tiff.get());
  }
}

}  // namespace alignability::test
