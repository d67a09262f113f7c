// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/occupancy_difference_picture.hpp"

#include <gmock/gmock.h>

#include "tests/core/temporary_folder.hpp"
#include "tests/core/thrown_message.hpp"
#include "tests/costmap/ascii_map.hpp"
#include "tests/pictures/read_png.hpp"

namespace alignability {
namespace {

using test::ascii_map;
using test::Picture;

const Colour kRed = colour_from_hex(0xe2001a);
const Colour kBlue = colour_from_hex(0x1f4fd8);

// How many pixels have the colour beyond those of the key's swatch.
int count_on_map(const OccupancyMap& first, const OccupancyMap& second, const Colour& colour) {
  const test::TemporaryFolder folder;
  const auto draw = [&](const OccupancyMap& other) {
    draw_occupancy_difference(occupancy_difference(first, other), {}, folder / "a.png");
    return Picture(folder / "a.png").count(colour);
  };
  return draw(second) - draw(first);
}

TEST(OccupancyDifferencePicture, ShowsTheFirstAloneInRedAndTheSecondAloneInBlue) {
  const OccupancyMap wall_left = ascii_map(1.0, {".#......", ".#......", ".#......", ".#......"});
  const OccupancyMap wall_right = ascii_map(1.0, {".....#..", ".....#..", ".....#..", ".....#.."});
  const int cell = 1400 / 8;
  EXPECT_NEAR(count_on_map(wall_left, wall_right, kRed), 4 * cell * cell, 5 * cell);
  EXPECT_NEAR(count_on_map(wall_left, wall_right, kBlue), 4 * cell * cell, 5 * cell);
}

TEST(OccupancyDifferencePicture, HasNoRedWhereAWallLiesACellAside) {
  const OccupancyMap here = ascii_map(1.0, {"..#..", "..#.."});
  const OccupancyMap aside = ascii_map(1.0, {"...#.", "...#."});
  EXPECT_EQ(count_on_map(here, aside, kRed), 0);
  EXPECT_EQ(count_on_map(here, aside, kBlue), 0);
}

TEST(OccupancyDifferencePicture, IsNotAsLargeAsItsMaps) {
  const test::TemporaryFolder folder;
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 3000}, {3000, 1}, {1500, 800}}) {
    const OccupancyMap map(Grid<float>({.resolution = 0.05, .width = width, .height = height}, 0.0f));
    draw_occupancy_difference(occupancy_difference(map, map), {.title = "a site", .first = "SLAM", .second = "slice"}, folder / "a.png");
    const Picture picture(folder / "a.png");
    EXPECT_LT(std::max(picture.width(), picture.height()), 2000) << width << " x " << height;
  }
}

TEST(OccupancyDifferencePicture, AFileThatCannotBeWrittenIsNamed) {
  const test::TemporaryFolder folder;
  const OccupancyMap map = ascii_map(1.0, {"."});
  EXPECT_THAT(test::thrown_message([&] { draw_occupancy_difference(occupancy_difference(map, map), {}, folder / "no/a.png"); }),
              ::testing::StartsWith((folder / "no/a.png").string() + ": cannot be written"));
}

}  // namespace
}  // namespace alignability
