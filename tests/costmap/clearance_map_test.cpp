// SPDX-License-Identifier: BSD-3-Clause
#include "costmap/clearance_map.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/costmap/ascii_map.hpp"
#include "tests/costmap/segment_oracle.hpp"

namespace alignability {
namespace {

using test::ascii_map;
using test::brute_force_distance;
using test::random_map;

TEST(ClearanceMap, MeasuresToTheNearestSquareNotItsCentre) {
  const ClearanceMap clearance(ascii_map(1.0, {".......", ".......", ".......", "...#...", ".......", ".......", "......."}));
  EXPECT_DOUBLE_EQ(clearance.distance({1.5, 3.5}), 1.5) << "to the square's left edge at x = 3, or the border";
  EXPECT_DOUBLE_EQ(clearance.distance({2.75, 3.1}), 0.25);
  EXPECT_DOUBLE_EQ(clearance.distance({2.4, 2.2}), 1.0) << "to its corner (3, 3): a 0.6, 0.8, 1 triangle";
}

TEST(ClearanceMap, IsZeroInAndOnANonFreeCell) {
  const ClearanceMap clearance(ascii_map(1.0, {"....", ".#?.", "...."}));
  EXPECT_EQ(clearance.distance({1.5, 1.5}), 0.0);
  EXPECT_EQ(clearance.distance({2.5, 1.5}), 0.0) << "unknown is not free";
  for (const Eigen::Vector2d& edge : {Eigen::Vector2d{1.0, 1.5}, {1.0, 1.0}, {1.5, 2.0}, {3.0, 1.5}, {3.0, 2.0}}) {
    EXPECT_EQ(clearance.distance(edge), 0.0) << edge.transpose();
  }
}

TEST(ClearanceMap, TakesTheWorldBeyondTheMapForOccupied) {
  const ClearanceMap clearance(ascii_map(0.5, {"....", "....", "....", "...."}, {-1.0, -1.0}));
  EXPECT_DOUBLE_EQ(clearance.distance({0.0, 0.0}), 1.0);
  EXPECT_DOUBLE_EQ(clearance.distance({0.9, 0.0}), 1.0 - 0.9);
  EXPECT_EQ(clearance.distance({-1.0, 0.0}), 0.0);
  EXPECT_EQ(clearance.distance({1.0, 0.0}), 0.0);
  EXPECT_EQ(clearance.distance({5.0, 0.0}), 0.0);
  EXPECT_EQ(clearance.distance({std::numeric_limits<double>::quiet_NaN(), 0.0}), 0.0);
}

TEST(ClearanceMap, CountsACellAsFreeUpToOneHalf) {
  Grid<float> occupancy({.resolution = 1.0, .width = 3, .height = 1}, 0.0f);
  occupancy[Cell{1, 0}] = 0.5f;
  EXPECT_GT(ClearanceMap(OccupancyMap(occupancy)).distance({1.5, 0.5}), 0.0);
  occupancy[Cell{1, 0}] = std::nextafter(0.5f, 1.0f);
  EXPECT_EQ(ClearanceMap(OccupancyMap(occupancy)).distance({1.5, 0.5}), 0.0);
}

TEST(ClearanceMap, CallsADiskThatJustTouchesClear) {
  const ClearanceMap clearance(ascii_map(0.25, {"########", "........", "........", "........", "........", "########"}));
  const Eigen::Vector2d middle{1.0, 0.75};
  EXPECT_EQ(clearance.distance(middle), 0.5);
  EXPECT_TRUE(clearance.is_clear(middle, 0.5));
  EXPECT_FALSE(clearance.is_clear(middle, std::nextafter(0.5, 1.0)));
}

TEST(ClearanceMap, LetsNoPointRobotTouchAWall) {
  const ClearanceMap clearance(ascii_map(1.0, {".#."}));
  EXPECT_TRUE(clearance.is_clear({0.999, 0.5}, 0.0));
  EXPECT_FALSE(clearance.is_clear({1.0, 0.5}, 0.0));
  EXPECT_FALSE(clearance.is_clear({2.0, 0.5}, 0.0));
  EXPECT_FALSE(clearance.is_clear({0.0, 0.5}, 0.0)) << "the border";
}

struct Shape {
  int width;
  int height;
  double density;
};

class ClearanceOfRandomMaps : public ::testing::TestWithParam<Shape> {};

TEST_P(ClearanceOfRandomMaps, AgreesWithBruteForce) {
  const auto [width, height, density] = GetParam();
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> uniform;
    const double resolution = seed % 2 == 0 ? 0.05 : 0.25;
    const GridGeometry geometry{.resolution = resolution, .origin = {100 * uniform(random) - 50, -3.25}, .width = width, .height = height};
    const OccupancyMap map = random_map(random, geometry, density);
    const ClearanceMap clearance(map);
    const double tolerance = 1e-9 * (geometry.extent().norm() + geometry.origin.norm());
    for (int i = 0; i < 400; ++i) {
      Eigen::Vector2d share(uniform(random), uniform(random));
      if (i % 4 == 1) share.x() = static_cast<double>(random() % (static_cast<unsigned>(width) + 1)) / width;    // on a column's edge
      if (i % 4 == 2) share.y() = static_cast<double>(random() % (static_cast<unsigned>(height) + 1)) / height;  // on a row's
      if (i % 16 == 3) share = 1.2 * share.array() - 0.1;                                                        // some off the map
      const Eigen::Vector2d point = geometry.origin + share.cwiseProduct(geometry.extent());
      const double exact = brute_force_distance(map, point);
      const double distance = clearance.distance(point);
      EXPECT_NEAR(distance, exact, tolerance) << point.transpose();
      for (const double radius : {0.0, 0.3 * resolution, resolution, 2.7 * resolution, distance, 0.999 * distance, 1.001 * distance}) {
        EXPECT_EQ(clearance.is_clear(point, radius), distance >= radius && distance > 0.0) << point.transpose() << " radius " << radius;
      }
    }
  }
}

TEST_P(ClearanceOfRandomMaps, NeverOverstatesTheDistanceAtACentre) {
  const auto [width, height, density] = GetParam();
  constexpr std::uint64_t kSeed = 99;
  SCOPED_TRACE(kSeed);
  std::mt19937_64 random(kSeed);
  const GridGeometry geometry{.resolution = 0.05, .origin = {-10.55, -23.3}, .width = width, .height = height};
  const OccupancyMap map = random_map(random, geometry, density);
  const ClearanceMap clearance(map);
  for (std::size_t i = 0; i < geometry.size(); ++i) {
    const Cell cell = geometry.cell_of(i);
    const double exact = brute_force_distance(map, geometry.center(cell));
    EXPECT_LE(clearance.distance_at(cell), exact);
    EXPECT_NEAR(clearance.distance_at(cell), exact, 1e-5);
    EXPECT_EQ(clearance.distance_at(cell) > 0.0, map.is_free(cell));
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, ClearanceOfRandomMaps,
                         ::testing::Values(Shape{1, 1, 0.0}, Shape{1, 1, 1.0}, Shape{1, 17, 0.1}, Shape{23, 1, 0.1}, Shape{2, 2, 0.3},
                                           Shape{31, 19, 0.0}, Shape{19, 31, 1.0}, Shape{40, 30, 0.01}, Shape{30, 40, 0.05},
                                           Shape{25, 25, 0.3}, Shape{60, 7, 0.02}));

TEST(ClearanceMap, OfAnEmptyMapIsNowhereClear) {
  const ClearanceMap clearance(OccupancyMap(Grid<float>({.resolution = 1.0, .width = 0, .height = 0}, 0.0f)));
  EXPECT_EQ(clearance.distance({0.0, 0.0}), 0.0);
  EXPECT_FALSE(clearance.is_clear({0.0, 0.0}, 0.0));
}

}  // namespace
}  // namespace alignability
