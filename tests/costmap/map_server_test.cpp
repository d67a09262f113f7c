// SPDX-License-Identifier: BSD-3-Clause
#include "costmap/map_server.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/file.hpp"
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

std::string yaml(const std::string& image, const std::string& more = "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n") {
  return "image: " + image + "\nresolution: 0.05\norigin: [-1.5, 2.25, 0]\n" + more;
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
      EXPECT_NEAR(map.occupancy({shade % 16, 15 - shade / 16}).value(), std::rint(100.0 * shade / 255.0) / 100.0, 1e-6) << shade;
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
