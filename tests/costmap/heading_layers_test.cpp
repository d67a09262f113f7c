// SPDX-License-Identifier: BSD-3-Clause
#include "costmap/heading_layers.hpp"

#include <gmock/gmock.h>

#include "core/file.hpp"
#include "core/input_error.hpp"
#include "tests/core/temporary_folder.hpp"
#include "tests/core/thrown_message.hpp"
#include "tests/costmap/heading_maps.hpp"

namespace alignability {
namespace {

const GridGeometry kCells{.resolution = 1.0, .width = 3, .height = 2};

AlignabilityMap map_by_heading(std::size_t headings) {
  return test::heading_map(kCells, headings, [](const Eigen::Vector2d&, double yaw) { return static_cast<float>(0.1 * yaw); });
}

TEST(HeadingLayers, AreThoseOfTheirNamesInTheOrderOfYaw) {
  AlignabilityMap map = map_by_heading(8);
  std::swap(map.layers[3], map.layers[6]);
  const auto layers = heading_layers(map);
  ASSERT_EQ(layers.size(), 8u);
  for (std::size_t k = 0; k < 8; ++k) EXPECT_EQ(layers[k], map.find_layer("alpha_heading_" + std::to_string(k)));
}

TEST(HeadingLayers, AreNoneOfAMapThatIsTheSameAtAllHeadings) {
  AlignabilityMap map = map_by_heading(0);
  map.layers.push_back({"alpha_mean", Grid<float>(kCells, 0.0f)});
  EXPECT_TRUE(heading_layers(map).empty());
}

TEST(HeadingLayers, AreRefusedWhereOneIsMissingBetweenOthersOrStandsAlone) {
  AlignabilityMap map = map_by_heading(4);
  map.layers.erase(map.layers.begin() + 3);
  EXPECT_THAT([&] { heading_layers(map); },
              testing::ThrowsMessage<std::invalid_argument>("of 3 headings the layer 'alpha_heading_2' is missing"));
  map.layers.resize(2);
  EXPECT_THROW(heading_layers(map), std::invalid_argument);
  map.layers.push_back({"alpha_heading_x", Grid<float>(kCells, 0.0f)});
  EXPECT_THROW(heading_layers(map), std::invalid_argument);
}

TEST(HeadingLayers, AreRefusedOnAnotherGrid) {
  AlignabilityMap map = map_by_heading(2);
  map.layers.back().values = Grid<float>({.resolution = 1.0, .width = 2, .height = 2}, 0.5f);
  EXPECT_THROW(heading_layers(map), std::invalid_argument);
}

TEST(HeadingLayers, HaveTheirBestCellByCell) {
  AlignabilityMap map = map_by_heading(3);
  map.layers[2].values[1] = 0.9f;
  map.layers[1].values[4] = std::numeric_limits<float>::quiet_NaN();
  map.layers[3].values[5] = std::numeric_limits<float>::quiet_NaN();
  const Grid<float> best = best_over_headings(map);
  EXPECT_EQ(best[0], map.layers[3].values[0]);
  EXPECT_EQ(best[1], 0.9f);
  EXPECT_TRUE(std::isnan(best[4]));
  EXPECT_TRUE(std::isnan(best[5]));
  map.layers.resize(1);
  EXPECT_EQ(best_over_headings(map).values(), map.alpha().values());
}

TEST(HeadingLayers, ComeBackFromAFile) {
  const test::TemporaryFolder folder;
  const AlignabilityMap map = map_by_heading(8);
  write_alignability_map(map, folder / "map");
  const AlignabilityMap read = read_alignability_map(folder / "map.yaml");
  const auto layers = heading_layers(read);
  ASSERT_EQ(layers.size(), 8u);
  for (std::size_t k = 0; k < 8; ++k) EXPECT_EQ(layers[k]->values(), map.find_layer(heading_layer_name(k))->values());
}

TEST(HeadingLayers, OfAFileAreCheckedWhereItNamesThem) {
  const test::TemporaryFolder folder;
  AlignabilityMap map = map_by_heading(4);
  map.layers.erase(map.layers.begin() + 2);
  write_alignability_map(map, folder / "gap");
  EXPECT_THAT(test::thrown_message([&] { read_alignability_map(folder / "gap.yaml"); }),
              testing::HasSubstr("gap.yaml:5:9: of 3 headings the layer 'alpha_heading_1' is missing"));
  map = map_by_heading(2);
  map.layers.back().values[0] = 1.5f;
  write_alignability_map(map, folder / "beyond");
  EXPECT_THROW(read_alignability_map(folder / "beyond.yaml"), InputError);
}

}  // namespace
}  // namespace alignability
