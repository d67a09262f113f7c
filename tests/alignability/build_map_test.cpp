// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/build_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "tests/alignability/coarse_lidar.hpp"
#include "tests/alignability/simulated.hpp"
#include "tests/core/temporary_folder.hpp"
#include "tests/costmap/ascii_map.hpp"

namespace alignability {
namespace {

using test::box;

// 4 × 3 m of floor within walls, a post in one cell.
Scene room() {
  return Scene({box({0.0, 0.0, -0.1}, {4.0, 3.0, 0.0}), box({-0.2, 0.0, 0.0}, {0.0, 3.0, 3.0}), box({4.0, 0.0, 0.0}, {4.2, 3.0, 3.0}),
                box({0.0, -0.2, 0.0}, {4.0, 0.0, 3.0}), box({0.0, 3.0, 0.0}, {4.0, 3.2, 3.0}), box({2.0, 1.0, 0.0}, {3.0, 2.0, 3.0})});
}

OccupancyMap room_occupancy() { return test::ascii_map(0.5, {"........", "........", "....##..", "....##..", "........", "......??"}); }

LidarModel small_lidar() {
  LidarModel lidar = test::coarse_lidar();
  lidar.name = "test";
  lidar.rate = 10.0;
  lidar.T_base_lidar.translation().z() = 1.0;
  return lidar;
}

MapOptions few_samples() {
  MapOptions options;
  options.samples = 3;
  options.alignability.segmentation.range_min = 0.1;
  return options;
}

// Equal to the bit, NaN included.
bool same_bytes(const AlignabilityMap& a, const AlignabilityMap& b) {
  const auto bits = [](float value) { return std::bit_cast<std::uint32_t>(value); };
  return a.layers.size() == b.layers.size() && std::ranges::equal(a.layers, b.layers, [&](const auto& left, const auto& right) {
           return left.name == right.name && std::ranges::equal(left.values.values(), right.values.values(), {}, bits, bits);
         });
}

TEST(BuildMap, EvaluatesTheCellsThatAreFreeEnough) {
  const AlignabilityMap map = build_alignability_map(room(), room_occupancy(), small_lidar(), few_samples());
  EXPECT_EQ(map.geometry.width, 4);
  EXPECT_EQ(map.geometry.height, 3);
  for (std::size_t i = 0; i < map.geometry.size(); ++i) {
    const Cell cell = map.geometry.cell_of(i);
    const bool post = cell == Cell{2, 1};
    EXPECT_EQ(std::isnan(map.alpha()[i]), post) << cell.x << ' ' << cell.y;
    if (post) continue;
    EXPECT_GE(map.alpha()[i], 0.0f);
    EXPECT_LE(map.alpha()[i], 1.0f);
    EXPECT_EQ((*map.find_layer("samples"))[i], 3.0f);
    const Eigen::Vector3f weak((*map.find_layer("weak_x"))[i], (*map.find_layer("weak_y"))[i], (*map.find_layer("weak_z"))[i]);
    EXPECT_NEAR(weak.norm(), 1.0f, 1e-5f);
  }
}

TEST(BuildMap, GoesOnFromItsCheckpointToTheSameBytes) {
  const AlignabilityMap undisturbed = build_alignability_map(room(), room_occupancy(), small_lidar(), few_samples());
  const test::TemporaryFolder folder;
  MapOptions options = few_samples();
  options.threads = 2;
  options.checkpoint = folder / "map.part";
  std::stop_source stop;
  options.stop = stop.get_token();
  options.progress = [&](Progress progress) {
    if (progress.done == 4) stop.request_stop();
  };
  EXPECT_THROW(build_alignability_map(room(), room_occupancy(), small_lidar(), options), Interrupted);
  options.stop = {};
  std::optional<std::size_t> there;
  options.progress = [&](Progress progress) {
    if (!there) there = progress.done;
  };
  EXPECT_TRUE(same_bytes(build_alignability_map(room(), room_occupancy(), small_lidar(), options), undisturbed));
  EXPECT_GE(there, 4u);
  EXPECT_LT(there, 11u);
  there.reset();
  EXPECT_TRUE(same_bytes(build_alignability_map(room(), room_occupancy(), small_lidar(), options), undisturbed));
  EXPECT_EQ(there, 11u);
}

TEST(BuildMap, GivesTheSameBytesForAnyNumberOfThreads) {
  MapOptions options = few_samples();
  options.threads = 1;
  const AlignabilityMap one = build_alignability_map(room(), room_occupancy(), small_lidar(), options);
  for (const int threads : {2, 5}) {
    options.threads = threads;
    EXPECT_TRUE(same_bytes(one, build_alignability_map(room(), room_occupancy(), small_lidar(), options))) << threads;
  }
  options.seed = 2;
  EXPECT_FALSE(same_bytes(one, build_alignability_map(room(), room_occupancy(), small_lidar(), options)));
}

TEST(BuildMap, EvaluatesSomeCellsAsItWouldAll) {
  MapOptions options = few_samples();
  const AlignabilityMap all = build_alignability_map(room(), room_occupancy(), small_lidar(), options);
  options.cells = std::vector<Cell>{{0, 0}, {3, 2}};
  const AlignabilityMap some = build_alignability_map(room(), room_occupancy(), small_lidar(), options);
  EXPECT_EQ(some.alpha()[Cell(0, 0)], all.alpha()[Cell(0, 0)]);
  EXPECT_EQ(some.alpha()[Cell(3, 2)], all.alpha()[Cell(3, 2)]);
  EXPECT_TRUE(std::isnan(some.alpha()[Cell(1, 0)]));
  options.cells = std::vector<Cell>{{4, 0}};
  EXPECT_THROW(build_alignability_map(room(), room_occupancy(), small_lidar(), options), std::invalid_argument);
}

TEST(BuildMap, TellsOfItsProgressAndStopsWhenAsked) {
  MapOptions options = few_samples();
  std::vector<std::size_t> done;
  options.progress = [&](Progress progress) {
    EXPECT_EQ(progress.total, 11u);
    done.push_back(progress.done);
  };
  build_alignability_map(room(), room_occupancy(), small_lidar(), options);
  EXPECT_TRUE(std::ranges::is_sorted(done));
  EXPECT_EQ(done.back(), 11u);
  std::stop_source stop;
  options.stop = stop.get_token();
  options.progress = [&](Progress progress) {
    if (progress.done == 2) stop.request_stop();
  };
  EXPECT_THROW(build_alignability_map(room(), room_occupancy(), small_lidar(), options), Interrupted);
}

TEST(BuildMap, LeavesOutPlacesWhereTheSensorWouldBeInsideSomething) {
  // The occupancy map knows nothing of a slab at the sensor's height over one cell.
  const Scene scene(
      {box({0.0, 0.0, -0.1}, {2.0, 1.0, 0.0}), box({-0.2, 0.0, 0.0}, {0.0, 1.0, 3.0}), box({1.0, 0.0, 0.5}, {2.0, 1.0, 1.5})});
  const OccupancyMap occupancy = test::ascii_map(0.5, {"....", "...."});
  const AlignabilityMap map = build_alignability_map(scene, occupancy, small_lidar(), few_samples());
  EXPECT_EQ((*map.find_layer("samples"))[Cell(1, 0)], 0.0f);
  EXPECT_TRUE(std::isnan(map.alpha()[Cell(1, 0)]));
  EXPECT_EQ((*map.find_layer("samples"))[Cell(0, 0)], 3.0f);
}

TEST(BuildMap, RefusesOptionsOutOfRange) {
  const auto build = [](auto change) {
    MapOptions options;
    change(options);
    return build_alignability_map(room(), room_occupancy(), small_lidar(), options);
  };
  EXPECT_THROW(build([](MapOptions& options) { options.samples = 0; }), std::invalid_argument);
  EXPECT_THROW(build([](MapOptions& options) { options.resolution = 0.4; }), std::invalid_argument);
  EXPECT_THROW(build([](MapOptions& options) { options.resolution = std::nan(""); }), std::invalid_argument);
  EXPECT_THROW(build([](MapOptions& options) { options.range_max = -1.0; }), std::invalid_argument);
}

}  // namespace
}  // namespace alignability
