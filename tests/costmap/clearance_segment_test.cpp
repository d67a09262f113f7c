// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>

#include "costmap/clearance_map.hpp"
#include "tests/costmap/ascii_map.hpp"
#include "tests/costmap/segment_oracle.hpp"

namespace alignability {
namespace {

using test::ascii_map;
using test::brute_force_distance;
using test::random_map;

OccupancyMap hall_with_thin_wall() {
  std::vector<std::string> lines(41, std::string(81, '.'));
  for (std::string& line : lines) line[40] = '#';
  return ascii_map(0.05, lines);
}

TEST(ClearanceOfASegment, NeverPassesThroughAWallOfOneCell) {
  const OccupancyMap map = hall_with_thin_wall();
  const ClearanceMap clearance(map);
  constexpr std::uint64_t kSeed = 3;
  SCOPED_TRACE(kSeed);
  std::mt19937_64 random(kSeed);
  std::uniform_real_distribution<double> across(0.01, 2.04);
  std::uniform_real_distribution<double> left(0.01, 1.99);
  std::uniform_real_distribution<double> right(2.06, 4.04);
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector2d from(left(random), across(random));
    const Eigen::Vector2d to(right(random), across(random));
    EXPECT_FALSE(clearance.is_clear(from, to, 0.0)) << from.transpose() << " to " << to.transpose();
    EXPECT_FALSE(clearance.is_clear(to, from, 0.0));
  }
}

TEST(ClearanceOfASegment, NeverSlipsBetweenCellsThatTouchAtACorner) {
  const ClearanceMap clearance(ascii_map(1.0, {"...#", "..#.", ".#..", "#..."}));
  EXPECT_FALSE(clearance.is_clear({1.2, 2.8}, {1.8, 1.2}, 0.0));
  EXPECT_FALSE(clearance.is_clear({0.5, 1.5}, {1.5, 0.5}, 0.0)) << "through the corner (1, 1) itself";
}

TEST(ClearanceOfASegment, CallsADiskThatJustTouchesAllTheWayClear) {
  const ClearanceMap clearance(ascii_map(0.25, {"##################", "..................", "..................", "..................",
                                                "..................", "##################"}));
  EXPECT_TRUE(clearance.is_clear({0.5, 0.75}, {4.0, 0.75}, 0.5));
  EXPECT_FALSE(clearance.is_clear({0.5, 0.75}, {4.0, 0.75}, std::nextafter(0.5, 1.0)));
  EXPECT_FALSE(clearance.is_clear({0.5, 0.75}, {4.0, std::nextafter(0.75, 1.0)}, 0.5));
}

TEST(ClearanceOfASegment, CallsADiskThatJustTouchesACornerInPassingClear) {
  const ClearanceMap clearance(ascii_map(1.0, {".........", ".........", ".........", "....#....", ".........", ".........", "........."}));
  EXPECT_TRUE(clearance.is_clear({2.0, 5.0}, {7.0, 5.0}, 1.0));
  EXPECT_FALSE(clearance.is_clear({2.0, 5.0}, {7.0, 5.0}, 1.0 + 1e-12));
}

TEST(ClearanceOfASegment, OfNoLengthIsThatOfItsPoint) {
  constexpr std::uint64_t kSeed = 5;
  SCOPED_TRACE(kSeed);
  std::mt19937_64 random(kSeed);
  const OccupancyMap map = random_map(random, {.resolution = 0.1, .origin = {-1.0, -1.0}, .width = 20, .height = 20}, 0.05);
  const ClearanceMap clearance(map);
  std::uniform_real_distribution<double> place(-1.1, 1.1);
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector2d point(place(random), place(random));
    for (const double radius : {0.0, 0.1, 0.25}) EXPECT_EQ(clearance.is_clear(point, point, radius), clearance.is_clear(point, radius));
  }
}

TEST(ClearanceOfASegment, IsNotClearOffTheMapOrForNan) {
  const ClearanceMap clearance(ascii_map(1.0, {"...", "...", "..."}));
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(clearance.is_clear({1.5, 1.5}, {4.5, 1.5}, 0.1));
  EXPECT_FALSE(clearance.is_clear({-4.5, 1.5}, {4.5, 1.5}, 0.1));
  EXPECT_FALSE(clearance.is_clear({1.5, 1.5}, {2.95, 1.5}, 0.1)) << "too near the border";
  EXPECT_FALSE(clearance.is_clear({1.5, 1.5}, {kNaN, 1.5}, 0.1));
  EXPECT_FALSE(clearance.is_clear({1.5, 1.5}, {1.5, 1.4}, kNaN));
  EXPECT_FALSE(clearance.is_clear({1.5, 1.5}, {1.5, 1.4}, 1e300));
  EXPECT_TRUE(clearance.is_clear({1.5, 1.5}, {2.85, 1.5}, 0.1));
}

class ClearanceOfRandomSegments : public ::testing::TestWithParam<double> {};

TEST_P(ClearanceOfRandomSegments, AgreesWithBruteForce) {
  int clear = 0;
  int blocked = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> uniform;
    const GridGeometry geometry{.resolution = seed % 2 == 0 ? 0.05 : 0.25, .origin = {uniform(random), -7.3}, .width = 24, .height = 33};
    const OccupancyMap map = random_map(random, geometry, GetParam());
    const ClearanceMap clearance(map);
    for (int i = 0; i < 120; ++i) {
      const Eigen::Vector2d from = geometry.origin + Eigen::Vector2d(uniform(random), uniform(random)).cwiseProduct(geometry.extent());
      Eigen::Vector2d to = geometry.origin + Eigen::Vector2d(uniform(random), uniform(random)).cwiseProduct(geometry.extent());
      if (i % 3 == 1) to = from + (i % 2 == 0 ? 0.1 : 0.3) * (to - from);
      if (i % 5 == 1) to.x() = from.x();
      if (i % 5 == 2) to.y() = from.y();
      const double exact = brute_force_distance(map, from, to);
      const double slack = 1e-9 * geometry.extent().norm();
      for (const double radius : {0.0, 0.4 * geometry.resolution, 1.5 * geometry.resolution, exact - slack, exact + slack}) {
        if (radius < 0.0 || std::abs(exact - radius) < 0.5 * slack) continue;
        const bool expected = exact > radius;
        EXPECT_EQ(clearance.is_clear(from, to, radius), expected)
            << from.transpose() << " to " << to.transpose() << " radius " << radius << " exact " << exact;
        EXPECT_EQ(clearance.is_clear(to, from, radius), expected);
        ++(expected ? clear : blocked);
      }
    }
  }
  EXPECT_GT(clear, 100);
  EXPECT_GT(blocked, 100);
}

INSTANTIATE_TEST_SUITE_P(Densities, ClearanceOfRandomSegments, ::testing::Values(0.0, 0.005, 0.02, 0.1));

TEST(ClearanceOfASegment, HoldsForEveryPointOfIt) {
  const OccupancyMap map = hall_with_thin_wall();
  const ClearanceMap clearance(map);
  EXPECT_TRUE(clearance.is_clear({0.3, 0.3}, {1.7, 1.7}, 0.29));
  constexpr std::uint64_t kSeed = 8;
  SCOPED_TRACE(kSeed);
  std::mt19937_64 random(kSeed);
  std::uniform_real_distribution<double> place(0.0, 2.0);
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector2d from(place(random), place(random));
    const Eigen::Vector2d to(place(random), place(random));
    const double radius = 0.2;
    if (!clearance.is_clear(from, to, radius)) continue;
    for (int k = 0; k <= 50; ++k) EXPECT_GE(clearance.distance(from + k / 50.0 * (to - from)), radius - 1e-12);
  }
}

}  // namespace
}  // namespace alignability
