// SPDX-License-Identifier: BSD-3-Clause
// Maps by heading, for lidars that do not see all around.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "alignability/build_map.hpp"
#include "alignability/map_update.hpp"
#include "alignability/merged_map.hpp"
#include "core/input_error.hpp"
#include "core/pose.hpp"
#include "costmap/heading_layers.hpp"
#include "tests/alignability/coarse_lidar.hpp"
#include "tests/alignability/simulated.hpp"
#include "tests/core/temporary_folder.hpp"
#include "tests/costmap/ascii_map.hpp"

namespace alignability {
namespace {

using test::box;
using testing::HasSubstr;

// A plain aisle along x, 3 m wide, which ends in the middle of another along y.
std::vector<TriangleMesh> t_junction() {
  return test::floor_and({box({-60, 1.5, 0}, {0, 1.7, 5}), box({-60, -1.7, 0}, {0, -1.5, 5}), box({-0.2, 1.5, 0}, {0, 60, 5}),
                          box({-0.2, -60, 0}, {0, -1.5, 5}), box({3, -60, 0}, {3.2, 60, 5})});
}

LidarModel lidar_of(double from_deg, double to_deg, int columns) {
  LidarModel lidar = test::coarse_lidar();
  lidar.sectors = {{.min = radians(from_deg), .max = radians(to_deg), .columns = columns}};
  lidar.T_base_lidar.translation().z() = 1.5;
  return lidar;
}

LidarModel forward() { return lidar_of(-45, 45, 181); }
LidarModel all_around() { return lidar_of(-180, 180, 720); }

MapOptions options_of(const SensorRig& sensor, int headings) {
  MapOptions options;
  options.samples = 3;
  options.headings = headings;
  options.alignability = for_lidar({}, sensor);
  return options;
}

// Two cells of the aisle, some metres before the junction.
OccupancyMap before_the_junction() { return test::ascii_map(1.0, {".."}, {-4.0, -0.5}); }

AlignabilityMap built(const SensorRig& sensor, int headings) {
  return build_alignability_map(Scene(t_junction()), before_the_junction(), sensor, options_of(sensor, headings));
}

float alpha_at(const AlignabilityMap& map, std::size_t heading, Cell cell = {0, 0}) { return (*heading_layers(map)[heading])[cell]; }

TEST(MapByHeading, FacingThePlainAisleScoresBelowFacingTheJunction) {
  const AlignabilityMap map = built(forward(), 8);
  ASSERT_EQ(heading_layers(map).size(), 8u);
  for (const Cell cell : {Cell{0, 0}, Cell{1, 0}}) {
    EXPECT_LT(alpha_at(map, 4, cell), 0.03f);
    EXPECT_GT(alpha_at(map, 0, cell), 5.0f * alpha_at(map, 4, cell));
  }
}

TEST(MapByHeading, AlphaIsThatOfTheLowestHeadingAndTheOtherLayersAreItsOwn) {
  const AlignabilityMap map = built(forward(), 4);
  const std::vector<const Grid<float>*> headings = heading_layers(map);
  for (std::size_t i = 0; i < map.geometry.size(); ++i) {
    const auto lowest = std::ranges::min_element(headings, {}, [i](const Grid<float>* layer) { return (*layer)[i]; });
    EXPECT_EQ(map.alpha()[i], (**lowest)[i]);
  }
  EXPECT_NEAR(std::abs((*map.find_layer("weak_x"))[0]), 1.0f, 0.01f);  // down the aisle it slides along
  EXPECT_EQ((*map.find_layer("samples"))[0], 3.0f);
}

TEST(MapByHeading, AllHeadingsAgreeOfALidarThatSeesAllAround) {
  const AlignabilityMap map = built(all_around(), 8);
  for (std::size_t heading = 1; heading < 8; ++heading) {
    EXPECT_NEAR(alpha_at(map, heading), alpha_at(map, 0), 0.02f) << heading;
  }
}

TEST(MapByHeading, TheFirstHeadingIsTheMapWithoutHeadings) {
  const AlignabilityMap without = built(forward(), 1);
  EXPECT_TRUE(heading_layers(without).empty());
  EXPECT_EQ(alpha_at(built(forward(), 4), 0), without.alpha()[0]);
}

TEST(MapByHeading, AHeadingAtWhichTheLidarWouldBeInAWallHasNoValue) {
  LidarModel ahead = all_around();
  ahead.T_base_lidar.translation().x() = 2.2;
  std::vector<TriangleMesh> thick = t_junction();
  thick.push_back(box({-60, 1.6, 0}, {-0.1, 4, 5}));
  const AlignabilityMap map = build_alignability_map(Scene(thick), before_the_junction(), ahead, options_of(ahead, 4));
  EXPECT_FALSE(std::isnan(alpha_at(map, 0)));
  EXPECT_TRUE(std::isnan(alpha_at(map, 1)));
  EXPECT_FALSE(std::isnan(alpha_at(map, 2)));
  EXPECT_FALSE(std::isnan(map.alpha()[0]));
}

TEST(MapByHeading, GoesOnFromACheckpointOfTheSameHeadingsAlone) {
  const test::TemporaryFolder folder;
  const Scene scene(t_junction());
  MapOptions options = options_of(forward(), 4);
  options.checkpoint = folder / "map.part";
  options.cells = std::vector{Cell{0, 0}};
  build_alignability_map(scene, before_the_junction(), forward(), options);
  options.cells.reset();
  const AlignabilityMap resumed = build_alignability_map(scene, before_the_junction(), forward(), options);
  EXPECT_EQ(alpha_at(resumed, 3, {0, 0}), alpha_at(built(forward(), 4), 3, {0, 0}));
  EXPECT_EQ(alpha_at(resumed, 3, {1, 0}), alpha_at(built(forward(), 4), 3, {1, 0}));
  options.headings = 8;
  EXPECT_THROW(build_alignability_map(scene, before_the_junction(), forward(), options), InputError);
}

TEST(MapByHeading, IsUpdatedAndMergedHeadingByHeadingWithItsLikeAlone) {
  const AlignabilityMap four = built(forward(), 4), eight = built(forward(), 8), none = built(forward(), 1);
  AlignabilityMap before = four;
  for (AlignabilityMap::Layer& layer : before.layers) layer.values[0] = 0.5f;
  EXPECT_EQ(alpha_at(updated(before, four, std::vector{Cell{0, 0}}), 2), alpha_at(four, 2));
  EXPECT_EQ(alpha_at(merged(before, four).map, 2), 0.5f);
  EXPECT_THROW(updated(eight, four, {}), std::invalid_argument);
  try {
    merged(none, four);
    FAIL() << "merged a map without headings with one that has them";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("alpha_heading_0"));
  }
}

TEST(MapByHeading, RefusesHeadingsThatAreNone) {
  EXPECT_THROW(built(forward(), 0), std::invalid_argument);
  EXPECT_THROW(built(forward(), 361), std::invalid_argument);
}

}  // namespace
}  // namespace alignability
