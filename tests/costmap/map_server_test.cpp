// SPDX-License-Identifier: BSD-3-Clause
#include "costmap/map_server.hpp"

#include <gmock/gmock.h>

#include <limits>
#include <optional>

#include "core/file.hpp"
#include "core/range.hpp"
#include "tests/core/temporary_folder.hpp"
#include "tests/costmap/ascii_map.hpp"
#include "tests/costmap/images.hpp"

namespace alignability {
namespace {

using test::drawn;
using test::pgm;
using test::PngKind;
using test::TemporaryFolder;
using test::write_png;
using ::testing::ElementsAre;
using ::testing::Optional;

std::string yaml(const std::string& image, const std::string& more = "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n") {
  return "image: " + image + "\nresolution: 0.05\norigin: [-1.5, 2.25, 0]\n" + more;
}

// A map of one row of grey pixels.
OccupancyMap read_shades(const std::vector<int>& shades, const std::string& more) {
  const TemporaryFolder folder;
  folder.write("map.pgm", pgm(static_cast<int>(shades.size()), shades));
  return read_occupancy_map(folder.write("map.yaml", yaml("map.pgm", more)));
}

TEST(MapServer, PutsTheTopRowOfTheImageAtTheTop) {
  const TemporaryFolder folder;
  folder.write("map.pgm", pgm(3, {0, 254, 205, 254, 254, 0}));
  const OccupancyMap map = read_occupancy_map(folder.write("map.yaml", yaml("map.pgm")));
  EXPECT_THAT(drawn(map), ElementsAre("#.?", "..#"));
  EXPECT_TRUE(map.is_free(Cell{0, 0}));
  EXPECT_FALSE(map.is_free(Cell{2, 0}));
  EXPECT_EQ(map.geometry(), (GridGeometry{.resolution = 0.05, .origin = {-1.5, 2.25}, .width = 3, .height = 2}));
}

TEST(MapServer, ReadsEveryKindOfPnmWithCommentsAlike) {
  const std::vector<std::string> images{
      "P5\n# CREATOR: map_saver.cpp 0.050 m/pix\n3 2\n255\n" + std::string("\x00\xfe\xcd\xfe\xfe\x00", 6),
      "P5 3 2 255\n" + std::string("\x00\xfe\xcd\xfe\xfe\x00", 6),
      "P2\n# text\n3 2\n# white\n255\n0 254 205\n254 254 0\n",
      "P2\n3 2 255\n0\n254\n205\n254\n254\n0",
      "P3\n3 2\n255\n0 0 0 254 254 254 205 205 205\n254 254 254 254 254 254 0 0 0\n",
      "P6\n3 2\n255\n" + std::string("\x00\x00\x00\xfe\xfe\xfe\xcd\xcd\xcd\xfe\xfe\xfe\xfe\xfe\xfe\x00\x00\x00", 18),
  };
  for (const std::string& image : images) {
    SCOPED_TRACE(image);
    const TemporaryFolder folder;
    folder.write("map.pgm", image);
    EXPECT_THAT(drawn(read_occupancy_map(folder.write("map.yaml", yaml("map.pgm")))), ElementsAre("#.?", "..#"));
  }
}

TEST(MapServer, ReadsABitmapWhereOneIsBlack) {
  for (const std::string& image : {std::string("P1\n3 2\n1 0 0\n0 0 1\n"), std::string("P4\n3 2\n\x80\x20", 9)}) {
    SCOPED_TRACE(image);
    const TemporaryFolder folder;
    folder.write("map.pbm", image);
    EXPECT_THAT(drawn(read_occupancy_map(folder.write("map.yaml", yaml("map.pbm")))), ElementsAre("#..", "..#"));
  }
}

TEST(MapServer, CountsShadesUpToTheWhiteOfTheFile) {
  const TemporaryFolder folder;
  folder.write("map.pgm", "P2\n4 1\n100\n0 50 85 100\n");
  const auto map =
      read_occupancy_map(folder.write("map.yaml", yaml("map.pgm", "mode: scale\nnegate: 0\noccupied_thresh: 1\nfree_thresh: 0\n")));
  EXPECT_NEAR(map.occupancy({0, 0}).value(), 1.0f, 1e-6);
  EXPECT_NEAR(map.occupancy({1, 0}).value(), 0.5f, 0.003);
  EXPECT_NEAR(map.occupancy({2, 0}).value(), 0.15f, 0.003);
  EXPECT_NEAR(map.occupancy({3, 0}).value(), 0.0f, 1e-6);
}

TEST(MapServer, ReadsEveryKindOfPngAlike) {
  const TemporaryFolder folder;
  write_png(folder / "grey.png", PngKind::grey, 3, {0, 254, 205, 254, 254, 0});
  write_png(folder / "rgb.png", PngKind::rgb, 3, {0, 0, 0, 254, 254, 254, 205, 205, 205, 254, 254, 254, 254, 254, 254, 0, 0, 0});
  write_png(folder / "grey16.png", PngKind::grey16, 3, {0, 254 * 257, 205 * 257, 254 * 257, 254 * 257, 0});
  for (const char* image : {"grey.png", "rgb.png", "grey16.png"}) {
    SCOPED_TRACE(image);
    EXPECT_THAT(drawn(read_occupancy_map(folder.write("map.yaml", yaml(image)))), ElementsAre("#.?", "..#"));
  }
}

TEST(MapServer, KeepsTheValuesOfAPngWhateverItsGammaOrDepth) {
  const TemporaryFolder folder;
  std::vector<int> shades;
  for (int shade = 0; shade < 256; ++shade) shades.push_back(shade);
  std::vector<int> deep;
  for (int shade = 0; shade < 256; ++shade) deep.push_back(257 * shade);
  write_png(folder / "plain.png", PngKind::grey, 16, shades);
  write_png(folder / "gimp.png", PngKind::grey, 16, shades, 0.45455);
  write_png(folder / "deep.png", PngKind::grey16, 16, deep);
  for (const char* image : {"plain.png", "gimp.png", "deep.png"}) {
    SCOPED_TRACE(image);
    const auto map =
        read_occupancy_map(folder.write("map.yaml", yaml(image, "mode: scale\nnegate: 1\noccupied_thresh: 1\nfree_thresh: 0\n")));
    for (int shade = 0; shade < 256; ++shade)
      EXPECT_NEAR(map.occupancy({shade % 16, 15 - shade / 16}).value(), shade / 255.0, 1e-6) << shade;
  }
}

TEST(MapServer, AveragesTheColours) {
  const TemporaryFolder folder;
  write_png(folder / "map.png", PngKind::rgb, 2, {255, 255, 0, 30, 60, 90});
  const auto map =
      read_occupancy_map(folder.write("map.yaml", yaml("map.png", "mode: scale\nnegate: 0\noccupied_thresh: 1\nfree_thresh: 0\n")));
  EXPECT_NEAR(map.occupancy({0, 0}).value(), 1.0 / 3.0, 1e-6);
  EXPECT_NEAR(map.occupancy({1, 0}).value(), 1.0 - 60.0 / 255.0, 1e-6);
}

TEST(MapServer, TakesATransparentPixelForUnknownInModeScale) {
  const TemporaryFolder folder;
  write_png(folder / "map.png", PngKind::grey_alpha, 3, {255, 255, 255, 254, 0, 0});
  EXPECT_THAT(drawn(read_occupancy_map(
                  folder.write("map.yaml", yaml("map.png", "mode: scale\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n")))),
              ElementsAre(".??"));
}

TEST(MapServer, AveragesTheAlphaInInModeTrinaryAsNav2Does) {
  const TemporaryFolder folder;
  // (0 + 0 + 0 + 255)/4 is dark still; (205·3 + 255)/4 is light enough to be free; the rest are transparent.
  write_png(folder / "map.png", PngKind::rgba, 4, {0, 0, 0, 255, 205, 205, 205, 255, 254, 254, 254, 0, 0, 0, 0, 0});
  EXPECT_THAT(drawn(read_occupancy_map(folder.write("map.yaml", yaml("map.png")))), ElementsAre("#.?#"));
}

TEST(MapServer, ReadsGrey205AsTheThresholdSays) {
  EXPECT_THAT(drawn(read_shades({205}, "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n")), ElementsAre("?"));
  EXPECT_THAT(drawn(read_shades({205}, "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.25\n")), ElementsAre("."));
}

TEST(MapServer, CountsTheThresholdsThemselvesIn) {
  // 51, 102 and 153 of 255 are 0.2, 0.4 and 0.6.
  EXPECT_THAT(drawn(read_shades({101, 102, 103, 203, 204, 205}, "negate: 0\noccupied_thresh: 0.6\nfree_thresh: 0.2\n")),
              ElementsAre("##??.."));
  EXPECT_THAT(drawn(read_shades({154, 153, 152, 52, 51, 50}, "negate: 1\noccupied_thresh: 0.6\nfree_thresh: 0.2\n")),
              ElementsAre("##??.."));
  EXPECT_THAT(drawn(read_shades({203, 204, 205, 206}, "negate: 0\noccupied_thresh: 0.2\nfree_thresh: 0.1\n")), ElementsAre("##??"));
}

TEST(MapServer, AgreesWithWholeNumbersOnEveryShade) {
  std::vector<int> shades;
  for (int shade = 0; shade < 256; ++shade) shades.push_back(shade);
  for (const int percent_free : {0, 10, 20, 40}) {
    for (const int percent_occupied : {50, 60, 80, 100}) {
      for (const bool negate : {false, true}) {
        const OccupancyMap map = read_shades(shades, "negate: " + std::string(negate ? "true" : "false") +
                                                         "\noccupied_thresh: " + to_text(percent_occupied / 100.0) +
                                                         "\nfree_thresh: " + to_text(percent_free / 100.0) + "\n");
        for (int shade = 0; shade < 256; ++shade) {
          const int dark = negate ? shade : 255 - shade;
          const std::optional<float> expected = 100 * dark >= 255 * percent_occupied ? std::optional(1.0f)
                                                : 100 * dark <= 255 * percent_free   ? std::optional(0.0f)
                                                                                     : std::nullopt;
          EXPECT_EQ(map.occupancy({shade, 0}), expected)
              << shade << " negate " << negate << " free " << percent_free << " occupied " << percent_occupied;
        }
      }
    }
  }
}

TEST(MapServer, GradesWhatLiesBetweenInModeScale) {
  const OccupancyMap map = read_shades({255, 204, 153, 128, 51, 0}, "mode: scale\nnegate: 0\noccupied_thresh: 0.8\nfree_thresh: 0.2\n");
  EXPECT_THAT(map.occupancy({0, 0}), Optional(0.0f));
  EXPECT_THAT(map.occupancy({1, 0}), Optional(0.0f));
  EXPECT_NEAR(map.occupancy({2, 0}).value(), (0.4 - 0.2) / 0.6, 1e-6);
  EXPECT_NEAR(map.occupancy({3, 0}).value(), (127.0 / 255.0 - 0.2) / 0.6, 1e-6);
  EXPECT_THAT(map.occupancy({4, 0}), Optional(1.0f));
  EXPECT_THAT(map.occupancy({5, 0}), Optional(1.0f));
}

TEST(MapServer, ReadsTheShadeItselfAsAPercentageInModeRaw) {
  for (const char* negate : {"0", "1"}) {
    const OccupancyMap map = read_shades({0, 50, 51, 100, 101, 255},
                                         "mode: raw\nnegate: " + std::string(negate) + "\noccupied_thresh: 0.65\nfree_thresh: 0.196\n");
    EXPECT_THAT(drawn(map), ElementsAre("..##??"));
    EXPECT_NEAR(map.occupancy({1, 0}).value(), 0.5, 1e-7);
    EXPECT_NEAR(map.occupancy({2, 0}).value(), 0.51, 1e-7);
  }
}

TEST(MapServer, WritesTheThreeShadesAndThresholdsThatReadBack) {
  const TemporaryFolder folder;
  write_occupancy_map(test::ascii_map(0.05, {"#.?", "..."}, {-15.1, -25.0}), folder / "out");
  EXPECT_EQ(read_file(folder / "out.pgm", 1000), "P5\n3 2\n255\n" + std::string("\x00\xfe\xcd\xfe\xfe\xfe", 6));
  EXPECT_EQ(
      read_file(folder / "out.yaml", 1000),
      "image: out.pgm\nmode: trinary\nresolution: 0.05\norigin: [-15.1, -25, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n");
  EXPECT_EQ(folder.files(), 2);
}

TEST(MapServer, ReadsBackWhatItWrote) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> place(-1e3, 1e3);
    const GridGeometry geometry{.resolution = 0.001 + std::abs(place(random)) / 1e4,
                                .origin = {place(random), place(random)},
                                .width = 1 + static_cast<int>(random() % 50),
                                .height = 1 + static_cast<int>(random() % 50)};
    const OccupancyMap map = test::random_map(random, geometry, 0.4);
    const TemporaryFolder folder;
    write_occupancy_map(map, folder / "a.map");
    const OccupancyMap again = read_occupancy_map(folder / "a.map.yaml");
    EXPECT_EQ(again.geometry(), geometry) << "to the bit";
    EXPECT_EQ(drawn(again), drawn(map));
  }
}

TEST(MapServer, ReadsBackFromUnderAnyName) {
  for (const char* name :
       {"my map", "a: b", "#1", "- x", "'quoted'", "\"q\"", "*star", "true", "{a}", "größe", "tab\tname", "back\\slash"}) {
    SCOPED_TRACE(name);
    const TemporaryFolder folder;
    write_occupancy_map(test::ascii_map(1.0, {"#.?"}), folder / name);
    EXPECT_THAT(drawn(read_occupancy_map(folder / (std::string(name) + ".yaml"))), ElementsAre("#.?"));
  }
}

}  // namespace
}  // namespace alignability
