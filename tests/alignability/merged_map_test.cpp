// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/merged_map.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace alignability {
namespace {

using testing::ElementsAre;
using testing::NanSensitiveFloatEq;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

AlignabilityMap map_with(std::vector<float> alphas, const std::string& provenance, const Eigen::Vector2d& origin = {0.0, 0.0}) {
  const GridGeometry geometry{.resolution = 1.0, .origin = origin, .width = static_cast<int>(alphas.size()), .height = 1};
  AlignabilityMap map{.geometry = geometry, .layers = {}, .seed = 3, .options = "samples: 10\n", .sensor = "", .provenance = provenance};
  map.layers.push_back({"alpha", Grid<float>(geometry, alphas)});
  for (float& value : alphas) value *= 10.0f;
  map.layers.push_back({"samples", Grid<float>(geometry, alphas)});
  return map;
}

const std::string kLog = "log: scans\n", kScene = "scene: hall.sdf\n";

auto values_are(std::vector<float> values) {
  std::vector<testing::Matcher<float>> each;
  for (const float value : values) each.push_back(NanSensitiveFloatEq(value));
  return testing::ElementsAreArray(each);
}

TEST(MergedMap, TakesALogsValuesWhereItHasSome) {
  const AlignabilityMap log = map_with({kNan, 0.2f, kNan}, kLog), scene = map_with({0.5f, 0.6f, kNan}, kScene);
  for (const MergedMap& result : {merged(log, scene), merged(scene, log)}) {
    EXPECT_THAT(result.map.alpha().values(), values_are({0.5f, 0.2f, kNan}));
    EXPECT_THAT(result.map.find_layer("samples")->values(), values_are({5.0f, 2.0f, kNan}));
    EXPECT_THAT(result.map.find_layer("logged")->values(), values_are({0.0f, 1.0f, kNan}));
    EXPECT_EQ(result.taken, 1u);
    EXPECT_EQ(result.map.seed, 3u);
  }
}

TEST(MergedMap, TakesTheFirstOfTwoAlike) {
  const AlignabilityMap first = map_with({kNan, 0.2f}, kLog), second = map_with({0.5f, 0.6f}, kLog);
  EXPECT_THAT(merged(first, second).map.alpha().values(), values_are({0.5f, 0.2f}));
  EXPECT_THAT(merged(second, first).map.alpha().values(), values_are({0.5f, 0.6f}));
}

TEST(MergedMap, HasTheGridOfTheOtherAndTellsWhatIsOffIt) {
  const AlignabilityMap log = map_with({0.1f, 0.2f, 0.3f}, kLog, {1.0, 0.0}), scene = map_with({0.5f, 0.6f, 0.7f}, kScene);
  const MergedMap result = merged(log, scene);
  EXPECT_EQ(result.map.geometry, scene.geometry);
  EXPECT_THAT(result.map.alpha().values(), values_are({0.5f, 0.1f, 0.2f}));
  EXPECT_EQ(result.lost, 1u);
}

TEST(MergedMap, RemembersWhatWasLoggedWhenMergedAgain) {
  MergedMap once = merged(map_with({kNan, 0.2f, kNan}, kLog), map_with({0.5f, 0.6f, 0.7f}, kScene));
  once.map.provenance = "merged: [a, b]\n";
  const MergedMap twice = merged(map_with({kNan, kNan, 0.3f}, kLog), once.map);
  EXPECT_THAT(twice.map.find_layer("logged")->values(), values_are({0.0f, 1.0f, 1.0f}));
  EXPECT_EQ(twice.map.layers.size(), 3u);
}

TEST(MergedMap, IsRefusedForOtherCellsAndOtherLayers) {
  const AlignabilityMap scene = map_with({0.5f}, kScene);
  EXPECT_THROW(merged(map_with({0.5f}, kLog, {0.5, 0.0}), scene), std::invalid_argument);
  AlignabilityMap more = map_with({0.5f}, kLog);
  more.layers.push_back({"robust", Grid<float>(more.geometry, 0.1f)});
  EXPECT_THROW(merged(more, scene), std::invalid_argument);
  EXPECT_THROW(merged(scene, more), std::invalid_argument);
}

}  // namespace
}  // namespace alignability
