// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>

#include "costmap/risk_field.hpp"
#include "tests/costmap/ascii_map.hpp"

namespace alignability {
namespace {

using test::ascii_map;

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

// α-cells of 1 m, the first row at the top.
Grid<float> alpha_cells(const std::vector<std::vector<float>>& rows, const Eigen::Vector2d& origin = Eigen::Vector2d::Zero()) {
  Grid<float> alpha(
      {.resolution = 1.0, .origin = origin, .width = static_cast<int>(rows.front().size()), .height = static_cast<int>(rows.size())},
      kNone);
  for (std::size_t row = 0; row < rows.size(); ++row) {
    for (std::size_t x = 0; x < rows[row].size(); ++x)
      alpha[Cell{static_cast<int>(x), static_cast<int>(rows.size() - 1 - row)}] = rows[row][x];
  }
  return alpha;
}

// Everything free, four occupancy cells across an α-cell.
OccupancyMap open_floor(int width, int height) {
  return ascii_map(0.25,
                   std::vector<std::string>(static_cast<std::size_t>(4 * height), std::string(static_cast<std::size_t>(4 * width), '.')));
}

TEST(FillBorder, KeepsTheValuesThatThereAre) {
  const Grid<float> alpha = alpha_cells({{0.1f, 0.2f}, {0.3f, kNone}});
  const Grid<double> filled = fill_border(alpha, open_floor(2, 2));
  EXPECT_EQ((filled[Cell{0, 1}]), static_cast<double>(0.1f));
  EXPECT_EQ((filled[Cell{1, 1}]), static_cast<double>(0.2f));
  EXPECT_EQ((filled[Cell{0, 0}]), static_cast<double>(0.3f));
}

TEST(FillBorder, TakesTheMeanOfTheNeighboursReached) {
  const Grid<double> filled = fill_border(alpha_cells({{0.25f, 0.5f}, {0.75f, kNone}}), open_floor(2, 2));
  EXPECT_DOUBLE_EQ((filled[Cell{1, 0}]), 0.5);
}

TEST(FillBorder, SpreadsByOneRingOnly) {
  const Grid<double> filled = fill_border(alpha_cells({{0.5f, kNone, kNone, kNone, 1.0f}}), open_floor(5, 1));
  EXPECT_DOUBLE_EQ((filled[Cell{1, 0}]), 0.5);
  EXPECT_TRUE(std::isnan(filled[Cell{2, 0}])) << "two cells from either value";
  EXPECT_DOUBLE_EQ((filled[Cell{3, 0}]), 1.0);
}

TEST(FillBorder, DoesNotReachBehindAThinWall) {
  // The second α-cell begins with a wall of one occupancy cell; the rest of it is free, and nothing leads there.
  const std::vector<std::string> lines(4, "....#...");
  const Grid<double> filled = fill_border(alpha_cells({{0.5f, kNone}}), ascii_map(0.25, lines));
  EXPECT_TRUE(std::isnan(filled[Cell{1, 0}]));
}

TEST(FillBorder, TakesOnlyTheNeighboursOnItsOwnSideOfAWall) {
  const std::vector<std::string> lines(4, "....#.......");
  const Grid<double> filled = fill_border(alpha_cells({{0.1f, kNone, 0.75f}}), ascii_map(0.25, lines));
  EXPECT_DOUBLE_EQ((filled[Cell{1, 0}]), 0.75);
}

TEST(FillBorder, GoesThroughADoorWithinReach) {
  std::vector<std::string> lines(4, "....#...");
  lines[2] = "........";
  const Grid<double> filled = fill_border(alpha_cells({{0.5f, kNone}}), ascii_map(0.25, lines));
  EXPECT_DOUBLE_EQ((filled[Cell{1, 0}]), 0.5);
}

TEST(FillBorder, DoesNotGoDiagonallyBetweenTwoCornersThatTouch) {
  const OccupancyMap map = ascii_map(0.5, {"##..", "##..", "..##", "..##"});
  const Grid<double> filled = fill_border(alpha_cells({{kNone, kNone}, {0.5f, kNone}}), map);
  EXPECT_TRUE(std::isnan(filled[Cell{1, 1}]));
}

TEST(FillBorder, TakesTheLowerSideForACellThatIsAllWall) {
  const std::vector<std::string> lines(4, "....####....");
  EXPECT_DOUBLE_EQ((fill_border(alpha_cells({{0.25f, kNone, 0.75f}}), ascii_map(0.25, lines))[Cell{1, 0}]), 0.25);
  EXPECT_DOUBLE_EQ((fill_border(alpha_cells({{0.75f, kNone, 0.5f}}), ascii_map(0.25, lines))[Cell{1, 0}]), 0.5);
  EXPECT_DOUBLE_EQ((fill_border(alpha_cells({{kNone, kNone, 0.5f}}), ascii_map(0.25, lines))[Cell{1, 0}]), 0.5);
}

TEST(FillBorder, TakesTheMeanOfASideNotItsLowestCell) {
  std::vector<std::string> lines(8, "....####....");
  const Grid<double> filled = fill_border(alpha_cells({{0.25f, kNone, 0.5f}, {0.75f, kNone, 0.625f}}), ascii_map(0.25, lines));
  EXPECT_DOUBLE_EQ((filled[Cell{1, 0}]), 0.5) << "left 0.5, right 0.5625";
}

TEST(FillBorder, TakesUnknownForAWall) {
  const std::vector<std::string> lines(4, "....?...");
  EXPECT_TRUE(std::isnan(fill_border(alpha_cells({{0.5f, kNone}}), ascii_map(0.25, lines))[Cell{1, 0}]));
}

TEST(FillBorder, LeavesAWallWithoutValuesAroundIt) {
  const Grid<double> filled = fill_border(alpha_cells({{kNone, kNone}, {kNone, kNone}}), open_floor(2, 2));
  for (const double value : filled.values()) EXPECT_TRUE(std::isnan(value));
}

TEST(FillBorder, TakesTheWorldBeyondTheOccupancyMapForWall) {
  // The α-map has a column more than the occupancy map: that column is all wall.
  const Grid<double> filled = fill_border(alpha_cells({{0.5f, kNone, kNone}}), open_floor(2, 1));
  EXPECT_DOUBLE_EQ((filled[Cell{1, 0}]), 0.5);
  EXPECT_TRUE(std::isnan(filled[Cell{2, 0}]));
  EXPECT_DOUBLE_EQ((fill_border(alpha_cells({{0.5f, kNone}}), open_floor(1, 1))[Cell{1, 0}]), 0.5);
  EXPECT_TRUE(std::isnan(fill_border(alpha_cells({{0.5f, kNone}}, {100.0, 100.0}), open_floor(1, 1))[Cell{1, 0}]));
}

TEST(FillBorder, TakesGridsThatDoNotDivide) {
  const OccupancyMap map = ascii_map(0.3, std::vector<std::string>(7, std::string(7, '.')), {-0.05, -0.05});
  const Grid<double> filled = fill_border(alpha_cells({{0.5f, kNone}, {kNone, kNone}}), map);
  for (const double value : filled.values()) EXPECT_DOUBLE_EQ(value, 0.5);
}

}  // namespace
}  // namespace alignability
