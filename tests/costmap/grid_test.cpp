// SPDX-License-Identifier: BSD-3-Clause
#include "costmap/grid.hpp"

#include <gmock/gmock.h>

#include <limits>
#include <random>

namespace alignability {
namespace {

using ::testing::Optional;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(GridGeometry, FindsTheCellBelowAPointNotTheOneTowardsZero) {
  const GridGeometry geometry{.resolution = 1.0, .origin = {-2.0, -2.0}, .width = 4, .height = 4};
  EXPECT_THAT(geometry.cell_near({-0.5, -0.5}), Optional(Cell{1, 1}));
  EXPECT_THAT(geometry.cell_near({-1.5, 0.5}), Optional(Cell{0, 2}));
  EXPECT_THAT(geometry.cell_near({0.0, -0.25}), Optional(Cell{2, 1}));
}

TEST(GridGeometry, GivesACellItsLeftAndLowerEdge) {
  const GridGeometry geometry{.resolution = 0.5, .origin = {-1.0, 3.0}, .width = 4, .height = 2};
  EXPECT_THAT(geometry.cell_near({-1.0, 3.0}), Optional(Cell{0, 0}));
  EXPECT_THAT(geometry.cell_near({-0.5, 3.5}), Optional(Cell{1, 1}));
  EXPECT_THAT(geometry.cell_near({std::nextafter(-0.5, -1.0), std::nextafter(3.5, 0.0)}), Optional(Cell{0, 0}));
}

TEST(GridGeometry, KnowsNoCellOffTheMap) {
  const GridGeometry geometry{.resolution = 0.5, .origin = {-1.0, 3.0}, .width = 4, .height = 2};
  EXPECT_EQ(geometry.cell_near({1.0, 3.2}), std::nullopt) << "the right edge belongs to nobody";
  EXPECT_EQ(geometry.cell_near({0.0, 4.0}), std::nullopt) << "nor does the top one";
  EXPECT_EQ(geometry.cell_near({std::nextafter(-1.0, -2.0), 3.2}), std::nullopt);
  EXPECT_EQ(geometry.cell_near({0.0, std::nextafter(3.0, 0.0)}), std::nullopt);
  EXPECT_EQ(geometry.cell_near({1e300, 1e300}), std::nullopt);
  EXPECT_EQ(geometry.cell_near({-kInfinity, 3.2}), std::nullopt);
  EXPECT_EQ(geometry.cell_near({kInfinity, 3.2}), std::nullopt);
}

TEST(GridGeometry, KnowsNoCellForNan) {
  const GridGeometry geometry{.resolution = 0.5, .width = 4, .height = 2};
  EXPECT_EQ(geometry.cell_near({kNaN, 0.2}), std::nullopt);
  EXPECT_EQ(geometry.cell_near({0.2, kNaN}), std::nullopt);
}

TEST(GridGeometry, HasNoCellsWhenEmpty) {
  const GridGeometry geometry{.width = 0, .height = 5};
  EXPECT_EQ(geometry.size(), 0u);
  EXPECT_EQ(geometry.cell_near({0.0, 0.0}), std::nullopt);
}

TEST(GridGeometry, CountsMoreCellsThanAnIntHolds) {
  const GridGeometry geometry{.width = 1 << 20, .height = 1 << 20};
  EXPECT_EQ(geometry.size(), std::size_t{1} << 40);
  const Cell last{geometry.width - 1, geometry.height - 1};
  EXPECT_EQ(geometry.index(last), geometry.size() - 1);
  EXPECT_EQ(geometry.cell_of(geometry.size() - 1), last);
}

TEST(GridGeometry, FindsTheCellOfEachCentreAgainWhereverTheOriginLies) {
  constexpr std::uint64_t kSeed = 11;
  SCOPED_TRACE(kSeed);
  std::mt19937_64 random(kSeed);
  std::uniform_real_distribution<double> place(-1000.0, 1000.0);
  for (const double resolution : {0.01, 0.03, 0.05, 0.1, 1.0, 1.0 / 3.0, 7.0}) {
    for (int i = 0; i < 500; ++i) {
      const GridGeometry geometry{.resolution = resolution, .origin = {place(random), place(random)}, .width = 1674, .height = 1006};
      const Cell cell{static_cast<int>(random() % 1674), static_cast<int>(random() % 1006)};
      EXPECT_THAT(geometry.cell_near(geometry.center(cell)), Optional(cell));
      EXPECT_EQ(geometry.cell_of(geometry.index(cell)), cell);
      EXPECT_LT((geometry.center(cell) - 0.5 * (geometry.corner(cell) + geometry.corner({cell.x + 1, cell.y + 1}))).norm(), 1e-9);
    }
  }
}

TEST(Grid, CountsRowsFromTheBottom) {
  const Grid<int> grid({.width = 3, .height = 2}, std::vector<int>{1, 2, 3, 4, 5, 6});
  EXPECT_EQ((grid[Cell{0, 0}]), 1);
  EXPECT_EQ((grid[Cell{2, 0}]), 3);
  EXPECT_EQ((grid[Cell{0, 1}]), 4);
  EXPECT_EQ(grid[std::size_t{5}], 6);
}

TEST(Grid, RefusesValuesThatDoNotFitItsGeometry) {
  EXPECT_THROW(Grid<int>({.width = 3, .height = 2}, std::vector<int>(5)), std::invalid_argument);
  EXPECT_THROW(Grid<int>({.resolution = 0.0, .width = 1, .height = 1}, 0), std::invalid_argument);
  EXPECT_THROW(Grid<int>({.resolution = -1.0, .width = 1, .height = 1}, 0), std::invalid_argument);
  EXPECT_THROW(Grid<int>({.resolution = kNaN, .width = 1, .height = 1}, 0), std::invalid_argument);
  EXPECT_THROW(Grid<int>({.width = -1, .height = -1}, std::vector<int>(1)), std::invalid_argument);
  EXPECT_THROW(Grid<int>({.width = 0, .height = -1}, std::vector<int>()), std::invalid_argument);
}

}  // namespace
}  // namespace alignability
