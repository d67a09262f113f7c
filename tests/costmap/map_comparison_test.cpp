// SPDX-License-Identifier: BSD-3-Clause
#include "costmap/map_comparison.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace alignability {
namespace {

using testing::ElementsAre;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

GridGeometry square(int side) { return {.resolution = 1.0, .origin = {10.0, -5.0}, .width = side, .height = side}; }

AlignabilityMap map_with(const GridGeometry& geometry, std::vector<float> alphas, float samples = 10.0f, float iqr = 0.02f) {
  AlignabilityMap map{.geometry = geometry, .layers = {}, .options = "", .sensor = "", .provenance = "scene: hall.sdf\n"};
  Grid<float> count(geometry, samples), spread(geometry, iqr);
  for (std::size_t i = 0; i < alphas.size(); ++i) {
    if (std::isnan(alphas[i])) count[i] = spread[i] = kNan;
  }
  map.layers.push_back({"alpha", Grid<float>(geometry, std::move(alphas))});
  map.layers.push_back({"samples", std::move(count)});
  map.layers.push_back({"iqr", std::move(spread)});
  return map;
}

AlignabilityMap logged(AlignabilityMap map) {
  map.provenance = "log: scans\n";
  return map;
}

TEST(MapComparison, SumsUpTheCellsThatHaveAValueInBoth) {
  const MapComparison result =
      compare_maps(map_with(square(2), {0.1f, 0.5f, kNan, 0.3f}), map_with(square(2), {0.2f, 0.25f, 0.4f, 0.3f}), {});
  EXPECT_EQ(result.in_first, 3u);
  EXPECT_EQ(result.in_second, 4u);
  ASSERT_EQ(result.cells.size(), 3u);
  EXPECT_EQ(result.cells.front().cell, (Cell{1, 0}));
  EXPECT_EQ(result.cells.front().center, Eigen::Vector2d(11.5, -4.5));
  EXPECT_NEAR(result.cells.front().difference(), -0.25, 1e-6);
  EXPECT_NEAR(result.difference.median, 0.0, 1e-6);
  EXPECT_NEAR(result.magnitude.max, 0.25, 1e-6);
  EXPECT_NEAR(result.rank_correlation, 0.5, 1e-9);
  const Grid<float> difference = difference_grid(result, square(2));
  EXPECT_NEAR(difference[0], 0.1f, 1e-6f);
  EXPECT_TRUE(std::isnan(difference[2]));
}

TEST(MapComparison, CountsTheCellsThatCrossAThreshold) {
  const MapComparison result =
      compare_maps(map_with(square(2), {0.05f, 0.2f, 0.5f, 0.4f}), map_with(square(2), {0.1f, 0.05f, 0.39f, 0.45f}), {});
  EXPECT_EQ(result.critical.fell, 1u);
  EXPECT_EQ(result.critical.rose, 1u);
  EXPECT_EQ(result.safe.fell, 1u);
  EXPECT_EQ(result.safe.rose, 0u);
}

TEST(MapComparison, FindsTheCellsOfMapsThatLieAside) {
  const GridGeometry aside{.resolution = 1.0, .origin = {11.0, -5.0}, .width = 3, .height = 1};
  const MapComparison result = compare_maps(map_with(square(2), {0.1f, 0.2f, 0.3f, 0.4f}), map_with(aside, {0.25f, 0.6f, 0.7f}), {});
  ASSERT_EQ(result.cells.size(), 1u);
  EXPECT_EQ(result.cells.front().cell, (Cell{1, 0}));
  EXPECT_NEAR(result.cells.front().difference(), 0.05, 1e-6);
}

TEST(MapComparison, RefusesMapsWithoutCellsInCommon) {
  const AlignabilityMap map = map_with(square(1), {0.1f});
  EXPECT_THROW(compare_maps(map, map_with({.resolution = 0.5, .origin = {10.0, -5.0}, .width = 1, .height = 1}, {0.1f}), {}),
               std::invalid_argument);
  EXPECT_THROW(compare_maps(map, map_with({.resolution = 1.0, .origin = {10.5, -5.0}, .width = 1, .height = 1}, {0.1f}), {}),
               std::invalid_argument);
  EXPECT_THROW(compare_maps(map, map_with({.resolution = 1.0, .origin = {20.0, -5.0}, .width = 1, .height = 1}, {0.1f}), {}),
               std::invalid_argument);
  EXPECT_THROW(compare_maps(map, map_with({.resolution = 1.0, .origin = {1e12, -5.0}, .width = 1, .height = 1}, {0.1f}), {}),
               std::invalid_argument)
      << "farther than cells are counted";
  EXPECT_THROW(compare_maps(map, map_with(square(1), {kNan}), {}), std::invalid_argument);
}

TEST(MapComparison, RefusesThresholdsMarginsAndSignificancesOutOfRange) {
  const AlignabilityMap map = map_with(square(1), {0.1f});
  EXPECT_THROW(compare_maps(map, map, {.alpha_critical = 0.5}), std::invalid_argument);
  EXPECT_THROW(compare_maps(map, map, {.alpha_critical = -0.1}), std::invalid_argument);
  EXPECT_THROW(compare_maps(map, map, {.alpha_safe = 1.1}), std::invalid_argument);
  EXPECT_THROW(compare_maps(map, map, {.significance = 0.0}), std::invalid_argument);
  EXPECT_THROW(compare_maps(map, map, {.margin = kNan}), std::invalid_argument);
  EXPECT_THROW(compare_maps(map, map, {.significance = 1.0}), std::invalid_argument);
}

TEST(MapComparison, TakesAFallForOneOnlyBeyondMarginAndSpread) {
  const auto lower = [](float second, float iqr, double margin) {
    return compare_maps(map_with(square(1), {0.5f}, 10.0f, iqr), map_with(square(1), {second}, 10.0f, iqr), {.margin = margin}).lower;
  };
  EXPECT_EQ(lower(0.40f, 0.02f, 0.05), 1u);
  EXPECT_EQ(lower(0.46f, 0.02f, 0.05), 0u) << "within the margin";
  EXPECT_EQ(lower(0.46f, 0.02f, 0.00), 1u);
  EXPECT_EQ(lower(0.40f, 0.20f, 0.05), 0u) << "within the spread";
  EXPECT_EQ(lower(0.60f, 0.02f, 0.05), 0u) << "higher";
}

TEST(MapComparison, TakesALogsCellForOneSampleHoweverManyScansItHas) {
  const AlignabilityMap first = map_with(square(1), {0.5f}, 10.0f, 0.05f), second = map_with(square(1), {0.4f}, 100.0f, 0.05f);
  EXPECT_EQ(compare_maps(first, second, {}).lower, 1u);
  EXPECT_EQ(compare_maps(first, logged(second), {}).lower, 0u);
}

TEST(MapComparison, IsNotTestedWhereNoSpreadIsKnown) {
  const MapComparison result = compare_maps(map_with(square(1), {0.9f}, 1.0f, 0.0f), map_with(square(1), {0.1f}, 3.0f, 0.1f), {});
  EXPECT_FALSE(result.is_tested);
  EXPECT_EQ(result.lower, 0u);
  EXPECT_TRUE(std::isnan(result.cells.front().chance));
}

TEST(MapComparison, TakesTheSpreadOfTheOtherMapWhereOneHasTooFewSamples) {
  const MapComparison result = compare_maps(map_with(square(1), {0.9f}, 10.0f, 0.02f), map_with(square(1), {0.1f}, 1.0f, 0.0f), {});
  EXPECT_TRUE(result.is_tested);
  EXPECT_EQ(result.lower, 1u);
}

TEST(MapComparison, TakesTheSpreadOfTheSecondWhereTheFirstHasTooFewSamples) {
  const MapComparison result = compare_maps(map_with(square(1), {0.9f}, 1.0f, 0.0f), map_with(square(1), {0.1f}, 10.0f, 0.02f), {});
  EXPECT_TRUE(result.is_tested);
  EXPECT_EQ(result.lower, 1u);
}

TEST(MapComparison, TakesTheSpreadOfTheOtherMapWhereOneSaysNoneAtAll) {
  AlignabilityMap bare = map_with(square(1), {0.1f});
  const AlignabilityMap first = map_with(square(1), {0.9f});
  for (const char* dropped : {"iqr", "samples"}) {
    std::erase_if(bare.layers, [&](const AlignabilityMap::Layer& layer) { return layer.name == dropped; });
    const MapComparison result = compare_maps(first, bare, {});
    EXPECT_TRUE(result.is_tested) << dropped;
    EXPECT_EQ(result.lower, 1u) << dropped;
  }
  EXPECT_FALSE(compare_maps(bare, bare, {}).is_tested);
}

TEST(MapComparison, IsCertainOfAFallWhereNothingSpreads) {
  const AlignabilityMap first = map_with(square(1), {0.5f}, 10.0f, 0.0f);
  EXPECT_EQ(compare_maps(first, map_with(square(1), {0.4f}, 10.0f, 0.0f), {}).cells.front().chance, 0.0);
  EXPECT_EQ(compare_maps(first, map_with(square(1), {0.46f}, 10.0f, 0.0f), {}).cells.front().chance, 1.0) << "within the margin";
}

TEST(MapComparison, FindsTheWholeLowerWhereNoCellIsForItself) {
  const std::vector<float> even(16, 0.5f), lower(16, 0.42f);
  const AlignabilityMap first = map_with(square(4), even, 1.0f, 0.0f);
  const MapComparison result = compare_maps(first, map_with(square(4), lower, 1.0f, 0.0f), {});
  EXPECT_FALSE(result.is_tested);
  EXPECT_TRUE(result.is_lower_as_whole);
  EXPECT_NEAR(result.chance, std::pow(0.5, 16), 1e-9);
  EXPECT_FALSE(compare_maps(first, map_with(square(4), lower, 1.0f, 0.0f), {.margin = 0.1}).is_lower_as_whole);
  std::vector<float> half = even;
  std::fill(half.begin(), half.begin() + 8, 0.3f);
  EXPECT_FALSE(compare_maps(first, map_with(square(4), half, 1.0f, 0.0f), {}).is_lower_as_whole);
}

// 400 cells, each the median of ten draws: of 200 pairs of maps of the same site, few may have any cell called lower.
TEST(MapComparison, SeldomCallsACellLowerWhereNoneIs) {
  std::mt19937_64 engine(7);
  std::normal_distribution<float> normal;
  const auto draw_map = [&] {
    AlignabilityMap map = map_with(square(20), std::vector<float>(400, 0.5f));
    for (std::size_t i = 0; i < 400; ++i) {
      std::vector<float> draws(10);
      for (float& draw : draws) draw = 0.5f + 0.03f * normal(engine);
      std::ranges::sort(draws);
      map.layers[0].values[i] = 0.5f * (draws[4] + draws[5]);
      map.layers[2].values[i] = 0.5f * (draws[7] + draws[6]) - 0.5f * (draws[2] + draws[3]);
    }
    return map;
  };
  int alarms = 0, alarms_as_whole = 0;
  for (int pair = 0; pair < 200; ++pair) {
    const AlignabilityMap first = draw_map(), second = draw_map();
    const MapComparison result = compare_maps(first, second, {.margin = 0.0});
    alarms += result.lower > 0 ? 1 : 0;
    alarms_as_whole += result.is_lower_as_whole ? 1 : 0;
  }
  EXPECT_LE(alarms, 20);
  EXPECT_LE(alarms_as_whole, 20);
}

TEST(MapComparison, SaysHowMapsWereMadeDifferently) {
  AlignabilityMap first = map_with(square(1), {0.5f}), second = first;
  first.options = "samples: 10\nrange_max: 6.5\nstride: 1\n";
  second.options = "samples: 1\nstride: 4\n";
  EXPECT_THAT(differences_in_making(first, second),
              ElementsAre("range_max: 6.5 in the first, none in the second", "stride: 1 in the first, 4 in the second"));
  second.options = first.options;
  second.sensor = "name: another\n";
  EXPECT_TRUE(differences_in_making(first, second).empty()) << "nothing is known of the first's sensor";
  first.sensor = "name: one\n";
  EXPECT_THAT(differences_in_making(first, second), ElementsAre("the sensor file"));
  first.sensor.clear();
  first.options += "a line without a value\n";
  EXPECT_TRUE(differences_in_making(second, first).empty()) << "nothing is known of the second's sensor";
}

}  // namespace
}  // namespace alignability
