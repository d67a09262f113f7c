// SPDX-License-Identifier: BSD-3-Clause
#include "costmap/raster_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "costmap/alignability_map.hpp"
#include "costmap/float_tiff.hpp"
#include "tests/core/temporary_folder.hpp"
#include "tests/core/thrown_message.hpp"
#include "tests/costmap/tiff_files.hpp"

namespace alignability {
namespace {

using test::TiffPage;

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

class RasterFileTest : public testing::Test {
 protected:
  std::string refusal_of(const RasterFile& raster) const {
    return test::thrown_message([&] { read_raster(raster); });
  }

  test::TemporaryFolder folder;
};

TEST_F(RasterFileTest, IsATiffWhereItIsSaidToLie) {
  const GridGeometry pixels{.width = 3, .height = 2};
  const AlignabilityMap::Layer layer{"speed", Grid<float>(pixels, std::vector{1.0f, -2.5f, kNone, 4.0f, 5.0f, 60.0f})};
  detail::write_float_tiff(folder / "speed.tiff", {&layer, 1});
  const Grid<float> read = read_raster({.file = folder / "speed.tiff", .place = RasterPlace{0.5, {-1.0, 2.0}}});
  EXPECT_EQ(read.geometry(), (GridGeometry{.resolution = 0.5, .origin = {-1.0, 2.0}, .width = 3, .height = 2}));
  EXPECT_EQ((read[Cell{1, 0}]), -2.5f);
  EXPECT_EQ((read[Cell{2, 1}]), 60.0f);
  EXPECT_TRUE(std::isnan(read[Cell{2, 0}]));
}

TEST_F(RasterFileTest, IsAMapServerMapWhoseUnknownHasNoValue) {
  folder.write("m.pgm", "P5 3 1 255\n" + std::string{'\xff', '\x33', '\x00'});
  folder.write("m.yaml",
               "image: m.pgm\nresolution: 2\norigin: [1, -1, 0]\nnegate: 0\noccupied_thresh: 0.9\nfree_thresh: 0.1\nmode: scale\n");
  const Grid<float> read = read_raster({.file = folder / "m.yaml"});
  EXPECT_EQ(read.geometry(), (GridGeometry{.resolution = 2.0, .origin = {1.0, -1.0}, .width = 3, .height = 1}));
  EXPECT_EQ((read[Cell{0, 0}]), 0.0f);
  EXPECT_NEAR((read[Cell{1, 0}]), 0.87f, 0.01f);
  EXPECT_EQ((read[Cell{2, 0}]), 1.0f);
  folder.write("m.yaml", "image: m.pgm\nresolution: 2\norigin: [1, -1, 0]\nnegate: 0\noccupied_thresh: 0.9\nfree_thresh: 0.1\n");
  EXPECT_TRUE(std::isnan(read_raster({.file = folder / "m.yaml"})[Cell{1, 0}])) << "trinary";
}

TEST_F(RasterFileTest, IsALayerOfAnAlignabilityMap) {
  AlignabilityMap map;
  map.geometry = {.resolution = 1.0, .width = 2, .height = 1};
  map.layers = {{"alpha", Grid<float>(map.geometry, 0.5f)}, {"iqr", Grid<float>(map.geometry, std::vector{0.1f, kNone})}};
  write_alignability_map(map, folder / "a");
  EXPECT_EQ((read_raster({.file = folder / "a.yaml", .layer = "iqr"})[Cell{0, 0}]), 0.1f);
  EXPECT_EQ(refusal_of({.file = folder / "a.yaml", .layer = "irq"}),
            (folder / "a.yaml").string() + ": has no layer 'irq' (did you mean 'iqr'?)");
}

TEST_F(RasterFileTest, IsRefusedWhereItHasMorePixelsThanAGridMayHave) {
  constexpr std::uint32_t kTooWide = (1u << 20) + 1;
  {
    const std::unique_ptr<TIFF, void (*)(TIFF*)> tiff(TIFFOpen((folder / "wide.tiff").c_str(), "w"), TIFFClose);
    TIFFSetField(tiff.get(), TIFFTAG_IMAGEWIDTH, kTooWide);
    TIFFSetField(tiff.get(), TIFFTAG_IMAGELENGTH, 1);
    TIFFSetField(tiff.get(), TIFFTAG_BITSPERSAMPLE, 32);
    TIFFSetField(tiff.get(), TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_IEEEFP);
    TIFFSetField(tiff.get(), TIFFTAG_COMPRESSION, COMPRESSION_ADOBE_DEFLATE);
    TIFFSetField(tiff.get(), TIFFTAG_ROWSPERSTRIP, 1);
    std::vector<float> row(kTooWide, 0.0f);
    TIFFWriteScanline(tiff.get(), row.data(), 0);
  }
  EXPECT_NE(refusal_of({.file = folder / "wide.tiff", .place = RasterPlace{}}).find("must have from 1 to 1048576 pixels along a side"),
            std::string::npos);
}

TEST_F(RasterFileTest, IsRefusedWhereItIsNoneOfThese) {
  const RasterPlace place;
  EXPECT_NE(refusal_of({.file = folder / "none.tiff", .place = place}).find("none.tiff: "), std::string::npos);
  folder.write("text.tiff", "no tiff");
  EXPECT_NE(refusal_of({.file = folder / "text.tiff", .place = place}).find("not a TIFF"), std::string::npos);
  const struct {
    std::vector<TiffPage> pages;
    const char* message;
  } faults[] = {{{{.bits = 8, .format = SAMPLEFORMAT_UINT}}, "must hold rows of one 32-bit float a pixel"},
                {{{.samples = 3}}, "must hold rows of one 32-bit float a pixel"},
                {{{.width = 16, .height = 16, .tiled = true}}, "must hold rows of one 32-bit float a pixel"},
                {{{}, {}}, "has more pages than the map has layers, 1"}};
  for (const auto& [pages, message] : faults) {
    test::write_tiff(folder / "bad.tiff", pages);
    const std::string refusal = refusal_of({.file = folder / "bad.tiff", .place = place});
    EXPECT_NE(refusal.find(message), std::string::npos) << refusal;
  }
  EXPECT_NE(refusal_of({.file = folder / "none.yaml"}).find("none.yaml: no such file"), std::string::npos);
}

}  // namespace
}  // namespace alignability
