// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <random>

#include "costmap/risk_field.hpp"
#include "tests/costmap/ascii_map.hpp"
#include "tests/costmap/heading_maps.hpp"

namespace alignability {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
const GridGeometry kCells{.resolution = 1.0, .width = 10, .height = 10};
const GridGeometry kFine{.resolution = 0.25, .width = 40, .height = 40};

double uniform(std::mt19937_64& random, double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); }

Pose2 random_pose(std::mt19937_64& random) {
  return {uniform(random, -1.0, 11.0), uniform(random, -1.0, 11.0), uniform(random, -3.2, 3.2)};
}

// Some cells without a value at some headings.
AlignabilityMap random_map(std::mt19937_64& random, std::size_t headings, double gaps) {
  return test::heading_map(kCells, headings, [&](const Eigen::Vector2d&, double) {
    return uniform(random, 0.0, 1.0) < gaps ? kNone : static_cast<float>(uniform(random, 0.0, 0.8));
  });
}

OccupancyMap free_floor() { return OccupancyMap(Grid<float>(kFine, 0.0f)); }

// Good to the east, poor to the west, in all cells.
AlignabilityMap looks_east() {
  return test::heading_map(kCells, 8, [](const Eigen::Vector2d&, double yaw) { return static_cast<float>(0.25 + 0.25 * std::cos(yaw)); });
}

TEST(RiskByHeading, IsLinearBetweenTwoHeadings) {
  const RiskField field(looks_east(), free_floor(), {});
  EXPECT_TRUE(field.has_headings());
  EXPECT_EQ(field.risk(5.0, 5.0, 0.0), 0.0);
  EXPECT_NEAR(field.risk(5.0, 5.0, std::numbers::pi), 1.0, 1e-12);
  const double north = field.risk(5.0, 5.0, 0.5 * std::numbers::pi), north_west = field.risk(5.0, 5.0, 0.75 * std::numbers::pi);
  EXPECT_NEAR(field.risk(5.0, 5.0, 0.6 * std::numbers::pi), 0.6 * north + 0.4 * north_west, 1e-12);
}

TEST(RiskByHeading, OfACarDrivingBackwardIsThatOfWhereItLooks) {
  const RiskField field(looks_east(), free_floor(), {});
  const double west = std::numbers::pi;
  EXPECT_NEAR(field.integral(Arc({2.0, 5.0, 0.0}, 0.0, 4.0)), 0.0, 1e-9);
  EXPECT_NEAR(field.integral(Arc({6.0, 5.0, 0.0}, 0.0, -4.0)), 0.0, 1e-9) << "backward to the west, looking east";
  EXPECT_NEAR(field.integral(Arc({6.0, 5.0, west}, 0.0, 4.0)), 4.0, 1e-9);
}

TEST(RiskByHeading, IsNowhereBelowThatOfTheBestHeading) {
  constexpr std::uint64_t kSeed = 11;
  SCOPED_TRACE(kSeed);
  std::mt19937_64 random(kSeed);
  for (const UnknownPolicy policy : {UnknownPolicy::risky, UnknownPolicy::neutral, UnknownPolicy::blocked}) {
    const RiskField field(random_map(random, 5, 0.05), test::random_map(random, kFine, 0.1), {.unknown = policy});
    const RiskField best = field.best_over_headings();
    EXPECT_FALSE(best.has_headings());
    for (int i = 0; i < 500; ++i) {
      const Pose2 from = random_pose(random), to = random_pose(random);
      const Arc arc(from, uniform(random, -1.0, 1.0), uniform(random, -6.0, 6.0));
      EXPECT_GE(field.risk(from.x, from.y, from.yaw) + 1e-12, best.risk(from.x, from.y, 0.0));
      EXPECT_GE(field.integral(from, to) + 1e-11, best.integral(from, to));
      EXPECT_GE(field.integral(arc) + 1e-11, best.integral(arc));
      EXPECT_EQ(field.least_risk(from.position()), best.risk(from.x, from.y, 1.0));
      EXPECT_EQ(field.least_integral(from.position(), to.position()), best.integral(from, to));
      const double alpha = field.alpha(from.x, from.y, from.yaw), most = field.greatest_alpha(from.position());
      EXPECT_EQ(std::isnan(alpha), std::isnan(most));
      EXPECT_TRUE(std::isnan(alpha) || alpha <= most + 1e-12);
    }
  }
}

TEST(RiskByHeading, IsThatOfAPlainMapWhereAllHeadingsAgree) {
  std::mt19937_64 random(12);
  AlignabilityMap plain = random_map(random, 0, 0.0);
  for (std::size_t i = 0; i < kCells.size(); ++i) {
    plain.layers.front().values[i] = uniform(random, 0.0, 1.0) < 0.1 ? kNone : static_cast<float>(uniform(random, 0.0, 1.0));
  }
  AlignabilityMap layered = plain;
  for (std::size_t k = 0; k < 8; ++k) layered.layers.push_back({heading_layer_name(k), plain.alpha()});
  const OccupancyMap occupancy = test::random_map(random, kFine, 0.1);
  const RiskField a(plain, occupancy, {}), b(layered, occupancy, {});
  EXPECT_FALSE(a.has_headings());
  for (int i = 0; i < 300; ++i) {
    const Pose2 from = random_pose(random), to = random_pose(random);
    EXPECT_NEAR(a.integral(from, to), b.integral(from, to), 1e-11);
    EXPECT_EQ(a.least_integral(from.position(), to.position()), b.least_integral(from.position(), to.position()));
    EXPECT_EQ(a.least_integral(from.position(), to.position()), a.integral(from, to));
  }
}

TEST(RiskByHeading, AddsToThatOfOtherSources) {
  std::mt19937_64 random(13);
  const AlignabilityMap map = random_map(random, 8, 0.0);
  const OccupancyMap occupancy = free_floor();
  RiskOptions options;
  options.alpha_weight = 0.5;
  const RiskSource traffic{.name = "traffic", .weight = 2.0, .values = std::make_shared<Grid<float>>(kFine, 0.25f)};
  const RiskField alone(map, occupancy, options);
  options.sources.push_back(traffic);
  const RiskField both(map, occupancy, options);
  for (int i = 0; i < 100; ++i) {
    const Pose2 from = random_pose(random), to = random_pose(random);
    const double length = (to.position() - from.position()).norm();
    EXPECT_NEAR(both.integral(from, to), alone.integral(from, to) + 0.5 * length, 1e-11);
    EXPECT_NEAR(both.risk(from.x, from.y, from.yaw), alone.risk(from.x, from.y, from.yaw) + 0.5, 1e-12);
  }
}

TEST(RiskByHeading, TakesACellForUnknownWhereItIsAtOneHeading) {
  AlignabilityMap map = looks_east();
  for (int x = 3; x < 8; ++x) {
    for (int y = 3; y < 8; ++y) map.layers[4].values[Cell{x, y}] = kNone;
  }
  const RiskField field(map, free_floor(), {.unknown = UnknownPolicy::blocked});
  for (const double yaw : {0.0, 1.0, 3.0, -2.0}) {
    EXPECT_TRUE(std::isnan(field.alpha(5.5, 5.5, yaw)));
    EXPECT_FALSE(field.is_drivable_at({5.5, 5.5, yaw}));
    EXPECT_FALSE(field.is_drivable_along({1.5, 5.5, yaw}, {9.5, 5.5, yaw}));
    EXPECT_FALSE(field.is_drivable(Arc({5.5, 1.5, 0.5 * std::numbers::pi}, 0.0, 8.0)));
    EXPECT_TRUE(field.is_drivable_along({1.5, 1.5, yaw}, {9.5, 1.5, yaw}));
  }
}

TEST(RiskByHeading, KeepsAFloorAsItFaces) {
  const RiskField field(looks_east(), free_floor(), {.min_alpha = 0.3});
  const double west = std::numbers::pi;
  EXPECT_TRUE(field.is_drivable_at({5.0, 5.0, 0.0}));
  EXPECT_FALSE(field.is_drivable_at({5.0, 5.0, west}));
  EXPECT_TRUE(field.is_drivable(Eigen::Vector2d(5.0, 5.0))) << "facing east";
  EXPECT_TRUE(field.is_drivable(Eigen::Vector2d(5.0, 5.0), Eigen::Vector2d(2.0, 2.0)));
  EXPECT_TRUE(field.is_drivable_along({5.0, 5.0, 0.0}, {2.0, 5.0, 0.0}));
  EXPECT_FALSE(field.is_drivable_along({5.0, 5.0, 0.0}, {2.0, 5.0, west}));
  EXPECT_TRUE(field.is_drivable(Arc({5.0, 5.0, 0.0}, 0.0, -3.0)));
  EXPECT_FALSE(field.is_drivable(Arc({5.0, 5.0, 0.0}, 1.0, 3.0))) << "it comes to look west";
  const RiskField higher = field.with_floor(0.6);
  EXPECT_FALSE(higher.is_drivable(Eigen::Vector2d(5.0, 5.0))) << "no heading will do";
}

TEST(RiskByHeading, KeepsAFloorAlongAWayJustWhereEachPoseDoes) {
  constexpr std::uint64_t kSeed = 14;
  SCOPED_TRACE(kSeed);
  std::mt19937_64 random(kSeed);
  int kept = 0;
  for (int i = 0; i < 300; ++i) {
    const RiskField field(random_map(random, 4, 0.0), free_floor(), {});
    const Pose2 from = random_pose(random);
    const Pose2 to{from.x + uniform(random, -1.0, 1.0), from.y + uniform(random, -1.0, 1.0), from.yaw + uniform(random, -1.0, 1.0)};
    const Arc arc(from, uniform(random, -1.0, 1.0), uniform(random, -2.0, 2.0));
    double least = 1.0, least_of_arc = 1.0;
    for (int k = 0; k <= 1000; ++k) {
      const Pose2 at = between(from, to, k / 1000.0), on_arc = arc.at(arc.length() * k / 1000.0);
      least = std::min(least, field.alpha(at.x, at.y, at.yaw));
      least_of_arc = std::min(least_of_arc, field.alpha(on_arc.x, on_arc.y, on_arc.yaw));
    }
    EXPECT_TRUE(field.with_floor(std::max(0.0, least - 1e-3)).is_drivable_along(from, to));
    EXPECT_FALSE(field.with_floor(least + 1e-9).is_drivable_along(from, to));
    EXPECT_TRUE(field.with_floor(std::max(0.0, least_of_arc - 1e-3)).is_drivable(arc));
    EXPECT_FALSE(field.with_floor(least_of_arc + 1e-9).is_drivable(arc));
    kept += field.with_floor(0.2).is_drivable_along(from, to) ? 1 : 0;
  }
  EXPECT_GT(kept, 30);
}

}  // namespace
}  // namespace alignability
