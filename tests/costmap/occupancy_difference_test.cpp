// SPDX-License-Identifier: BSD-3-Clause
#include "costmap/occupancy_difference.hpp"

#include <gmock/gmock.h>

#include "tests/costmap/ascii_map.hpp"

namespace alignability {
namespace {

using test::ascii_map;
using ::testing::ElementsAre;

// ' ' not compared, '.' free, '#' occupied in both, '~' within a cell, '1' and '2' occupied in that one alone.
std::vector<std::string> drawn(const OccupancyDifference& difference) {
  const GridGeometry& geometry = difference.cells.geometry();
  std::vector<std::string> lines;
  for (int y = geometry.height - 1; y >= 0; --y) {
    lines.emplace_back();
    for (int x = 0; x < geometry.width; ++x) lines.back() += " .#~12"[static_cast<int>(difference.cells[Cell{x, y}])];
  }
  return lines;
}

TEST(OccupancyDifference, IsNoneBetweenEqualMaps) {
  const OccupancyMap map = ascii_map(0.5, {"#.?", "..#"});
  const OccupancyDifference difference = occupancy_difference(map, map);
  EXPECT_THAT(drawn(difference), ElementsAre("#. ", "..#"));
  EXPECT_EQ(difference.compared, 5u);
  EXPECT_EQ(difference.agreement(), 1.0);
}

TEST(OccupancyDifference, ForgivesAWallThatLiesACellAside) {
  EXPECT_THAT(drawn(occupancy_difference(ascii_map(1.0, {"..#...", "..#...", "..#..."}), ascii_map(1.0, {"...#..", "...#..", "...#.."}))),
              ElementsAre("..~~..", "..~~..", "..~~.."));
  EXPECT_THAT(drawn(occupancy_difference(ascii_map(1.0, {"#...", "....", "...."}), ascii_map(1.0, {"....", ".#..", "...."}))),
              ElementsAre("~...", ".~..", "...."))
      << "corners count";
}

TEST(OccupancyDifference, DoesNotForgiveTwoCells) {
  const OccupancyDifference difference = occupancy_difference(ascii_map(1.0, {".#....", ".#...."}), ascii_map(1.0, {"...#..", "...#.."}));
  EXPECT_THAT(drawn(difference), ElementsAre(".1.2..", ".1.2.."));
  EXPECT_EQ(difference.differing, 4u);
  EXPECT_DOUBLE_EQ(difference.agreement(), 8.0 / 12.0);
}

TEST(OccupancyDifference, ASolidAgainstItsOutlineDiffersWithinIt) {
  EXPECT_THAT(drawn(occupancy_difference(ascii_map(1.0, {"#####", "#...#", "#...#", "#...#", "#####"}),
                                         ascii_map(1.0, {"#####", "#####", "#####", "#####", "#####"}))),
              ElementsAre("#####", "#222#", "#222#", "#222#", "#####"))
      << "no free cell of the solid is near";
}

TEST(OccupancyDifference, ComparesNothingWhereOneKnowsNothing) {
  const OccupancyDifference difference = occupancy_difference(ascii_map(1.0, {"?#."}), ascii_map(1.0, {"#??"}));
  EXPECT_THAT(drawn(difference), ElementsAre("   "));
  EXPECT_EQ(difference.compared, 0u);
  EXPECT_TRUE(std::isnan(difference.agreement()));
}

TEST(OccupancyDifference, OfSwappedMapsIsSwapped) {
  std::mt19937_64 random(3);
  const GridGeometry geometry{.resolution = 0.1, .width = 40, .height = 30};
  const OccupancyMap first = test::random_map(random, geometry, 0.2);
  const OccupancyMap second = test::random_map(random, geometry, 0.2);
  const OccupancyDifference there = occupancy_difference(first, second);
  const OccupancyDifference back = occupancy_difference(second, first);
  EXPECT_EQ(there.differing, back.differing);
  std::vector<std::string> lines = drawn(back);
  for (std::string& line : lines) {
    for (char& letter : line) letter = letter == '1' ? '2' : letter == '2' ? '1' : letter;
  }
  EXPECT_EQ(drawn(there), lines);
}

TEST(OccupancyDifference, OfMapsWithOtherCellsIsRefused) {
  EXPECT_THROW(occupancy_difference(ascii_map(1.0, {".."}), ascii_map(1.0, {".", "."})), std::invalid_argument);
  EXPECT_THROW(occupancy_difference(ascii_map(1.0, {".."}), ascii_map(1.0, {".."}, {0.5, 0.0})), std::invalid_argument);
}

}  // namespace
}  // namespace alignability
