// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/cell_samples.hpp"

#include <gtest/gtest.h>

#include <random>

#include "alignability/build_map.hpp"
#include "tests/costmap/ascii_map.hpp"

namespace alignability {
namespace {

GridGeometry one_metre_cells(const OccupancyMap& occupancy) { return alignability_geometry(occupancy.geometry(), 1.0); }

TEST(FreePart, IsEvaluatedWhenAtMostHalfIsOccupied) {
  const OccupancyMap half = test::ascii_map(0.5, {"##", ".."});
  EXPECT_TRUE(FreePart(half, one_metre_cells(half), {0, 0}, {}).is_evaluated());
  const OccupancyMap more = test::ascii_map(0.5, {"##", "#."});
  EXPECT_FALSE(FreePart(more, one_metre_cells(more), {0, 0}, {}).is_evaluated());
  EXPECT_TRUE(FreePart(more, one_metre_cells(more), {0, 0}, {.max_occupied_share = 0.75}).is_evaluated());
}

TEST(FreePart, TakesTheUnknownForOccupied) {
  const OccupancyMap map = test::ascii_map(0.5, {"??", "#."});
  EXPECT_FALSE(FreePart(map, one_metre_cells(map), {0, 0}, {}).is_evaluated());
}

TEST(FreePart, TakesWhatLiesBeyondTheMapForOccupied) {
  const OccupancyMap map = test::ascii_map(0.25, {"....."});
  const GridGeometry cells = one_metre_cells(map);
  EXPECT_EQ(cells.width, 2);
  EXPECT_EQ(cells.height, 1);
  EXPECT_FALSE(FreePart(map, cells, {0, 0}, {}).is_evaluated());
}

TEST(FreePart, HasNoPlaceInACellWithoutFreeOnes) {
  const OccupancyMap map = test::ascii_map(0.5, {"##", "##"});
  EXPECT_FALSE(FreePart(map, one_metre_cells(map), {0, 0}, {.max_occupied_share = 1.0}).is_evaluated());
}

TEST(FreePart, GivesPlacesInFreeCellsOnlyAndInAllOfThemByArea) {
  // Cells of 0.3 m do not divide a metre: pieces are cut and weighted.
  const OccupancyMap map = test::ascii_map(0.3, {"....", ".#..", "..#.", "...."});
  const GridGeometry cells = one_metre_cells(map);
  const FreePart free(map, cells, {0, 0}, {});
  ASSERT_TRUE(free.is_evaluated());
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  constexpr int kPlaces = 20000;
  int in_last_column = 0;
  for (int i = 0; i < kPlaces; ++i) {
    const Eigen::Vector2d place = free.at((i + uniform(engine)) / kPlaces, uniform(engine), uniform(engine));
    EXPECT_TRUE(map.is_free(*map.geometry().cell_near(place)));
    EXPECT_EQ(cells.cell_near(place), (Cell{0, 0}));
    sum += place;
    if (place.x() > 0.9) ++in_last_column;
  }
  // 1 m² less two cells of 0.09 m²; the last column holds 0.1 m².
  EXPECT_NEAR(static_cast<double>(in_last_column) / kPlaces, 0.1 / 0.82, 0.005);
  const Eigen::Vector2d mean((0.5 - 0.09 * 0.45 - 0.09 * 0.75) / 0.82, (0.5 - 0.09 * 0.75 - 0.09 * 0.45) / 0.82);
  EXPECT_NEAR((sum / kPlaces - mean).norm(), 0.0, 0.01);
}

}  // namespace
}  // namespace alignability
