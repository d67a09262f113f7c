// SPDX-License-Identifier: BSD-3-Clause
#include "costmap/scenario_map.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "tests/costmap/heading_maps.hpp"

namespace alignability {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

AlignabilityMap map_of(const std::vector<float>& alphas) {
  AlignabilityMap map;
  map.geometry = {.resolution = 1.0, .width = static_cast<int>(alphas.size()), .height = 1};
  map.layers = {{"alpha", Grid<float>(map.geometry, alphas)}, {"samples", Grid<float>(map.geometry, 10.0f)}};
  return map;
}

const std::vector<AlignabilityMap> kRacks{map_of({0.5f, 0.1f, 0.3f}), map_of({0.2f, 0.4f, kNaN}), map_of({0.3f, 0.6f, 0.7f})};

TEST(ScenarioMap, IsTheWorstCaseAtQuantileZero) {
  const AlignabilityMap worst = scenario_map(kRacks, 0.0);
  EXPECT_EQ(worst.alpha()[0], 0.2f);
  EXPECT_EQ(worst.alpha()[1], 0.1f);
  EXPECT_TRUE(std::isnan(worst.alpha()[2])) << "in one of them nobody knows";
  EXPECT_EQ(worst.layers.size(), 1u);
}

TEST(ScenarioMap, IsTheMedianAndTheBestCaseAtGreaterQuantiles) {
  EXPECT_EQ(scenario_map(kRacks, 0.5).alpha().values(), (std::vector<float>{0.3f, 0.4f, 0.3f}));
  EXPECT_EQ(scenario_map(kRacks, 0.9).alpha().values(), (std::vector<float>{0.3f, 0.4f, 0.3f})) << "the lower of two";
  EXPECT_EQ(scenario_map(kRacks, 1.0).alpha().values(), (std::vector<float>{0.5f, 0.6f, 0.7f}));
}

TEST(ScenarioMap, OfOneMapIsThatMap) { EXPECT_EQ(scenario_map({kRacks.data(), 1}, 0.3).alpha().values(), kRacks[0].alpha().values()); }

TEST(ScenarioMap, RefusesNoMapsOtherGridsAndOtherQuantiles) {
  EXPECT_THROW(scenario_map({}, 0.0), std::invalid_argument);
  EXPECT_THROW(scenario_map(std::vector{kRacks[0], map_of({0.1f})}, 0.0), std::invalid_argument);
  EXPECT_THROW(scenario_map(kRacks, 1.5), std::invalid_argument);
  EXPECT_THROW(scenario_map(kRacks, std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
}

TEST(ScenarioMap, TakesEachHeadingByItself) {
  const GridGeometry cell{.resolution = 1.0, .width = 1, .height = 1};
  const auto facing = [&](float east, float west) {
    return test::heading_map(cell, 2, [=](const Eigen::Vector2d&, double yaw) { return yaw == 0.0 ? east : west; });
  };
  const AlignabilityMap worst = scenario_map(std::vector{facing(0.2f, 0.8f), facing(0.6f, 0.5f)}, 0.0);
  ASSERT_EQ(heading_layers(worst).size(), 2u);
  EXPECT_EQ((*heading_layers(worst)[0])[0], 0.2f);
  EXPECT_EQ((*heading_layers(worst)[1])[0], 0.5f);
  AlignabilityMap plain = facing(0.2f, 0.8f);
  plain.layers.resize(1);
  EXPECT_THROW(scenario_map(std::vector{facing(0.2f, 0.8f), plain}, 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace alignability
