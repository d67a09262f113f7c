// SPDX-License-Identifier: BSD-3-Clause
#include "costmap/occupancy_patches.hpp"

#include <gmock/gmock.h>

#include "tests/costmap/ascii_map.hpp"

namespace alignability {
namespace {

using test::ascii_map;
using test::drawn;
using ::testing::ElementsAre;

TEST(OccupancyPatches, FreeOnesSmallerThanTheAreaBecomeUnknown) {
  const OccupancyMap map = ascii_map(0.5, {"..#.", "..##", "##..", "?#.#"});
  EXPECT_THAT(drawn(without_small_patches(map, 0.75)), ElementsAre("..#?", "..##", "##..", "?#.#"));
  EXPECT_THAT(drawn(without_small_patches(map, 0.76)), ElementsAre("..#?", "..##", "##??", "?#?#"));
  EXPECT_EQ(drawn(without_small_patches(map, 0.0)), drawn(map));
}

TEST(OccupancyPatches, UnknownOnesAmidFreeCellsAndSmallerThanTheAreaBecomeFree) {
  const OccupancyMap map = ascii_map(0.5, {".......", ".??.?..", ".....#.", "?......", "..?#...", "......."});
  EXPECT_THAT(drawn(without_small_holes(map, 0.51)), ElementsAre(".......", ".......", ".....#.", "?......", "..?#...", "......."))
      << "neither at the edge nor beside what is occupied";
  EXPECT_THAT(drawn(without_small_holes(map, 0.5)), ElementsAre(".......", ".??....", ".....#.", "?......", "..?#...", "......."));
}

TEST(OccupancyPatches, OccupanciesStayAsTheyAre) {
  Grid<float> occupancy({.resolution = 1.0, .width = 2, .height = 1}, 0.0f);
  occupancy[Cell{0, 0}] = 0.3f;
  occupancy[Cell{1, 0}] = 0.7f;
  const OccupancyMap map = without_small_patches(OccupancyMap(occupancy), 1.0);
  EXPECT_EQ(map.occupancy({0, 0}), 0.3f);
  EXPECT_EQ(map.occupancy({1, 0}), 0.7f);
}

}  // namespace
}  // namespace alignability
