// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/monitor.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "tests/alignability/coarse_lidar.hpp"
#include "tests/alignability/simulated.hpp"

namespace alignability {
namespace {

using test::box;

// A room of 6 × 4 m whose ends may be cleared away, which leaves a corridor.
Scene room(bool has_ends) {
  std::vector<TriangleMesh> meshes{box({-30.0, 0.0, -0.1}, {36.0, 4.0, 0.0}), box({-30.0, -0.2, 0.0}, {36.0, 0.0, 3.0}),
                                   box({-30.0, 4.0, 0.0}, {36.0, 4.2, 3.0})};
  if (has_ends) {
    meshes.push_back(box({-0.2, 0.0, 0.0}, {0.0, 4.0, 3.0}));
    meshes.push_back(box({6.0, 0.0, 0.0}, {6.2, 4.0, 3.0}));
  }
  return Scene(meshes);
}

Scan seen(const Scene& scene, const Pose2& base, std::uint64_t sample) {
  const Eigen::Isometry3d pose(Eigen::Translation3d(base.x, base.y, 1.0) * Eigen::AngleAxisd(base.yaw, Eigen::Vector3d::UnitZ()));
  return simulate_scan(scene, test::coarse_lidar(), pose, {}, NoiseKey{1, 0, sample});
}

MonitorOptions options() {
  MonitorOptions options;
  options.alignability = for_lidar(options.alignability, test::coarse_lidar());
  return options;
}

AlignabilityMap map_with(float alpha) {
  AlignabilityMap map;
  map.geometry = {.resolution = 1.0, .width = 6, .height = 4};
  map.layers.push_back({"alpha", Grid<float>(map.geometry, alpha)});
  return map;
}

AlignabilityMap map_of_the_room() {
  return map_with(static_cast<float>(score(seen(room(true), {3.0, 2.0, 0.0}, 0), options().alignability).alignability.alpha));
}

TEST(Monitor, FindsNothingLowWhereTheSiteIsAsItWas) {
  Monitor monitor(map_of_the_room(), options());
  for (int i = 0; i < 3; ++i) {
    const MonitorReading reading = monitor.update(seen(room(true), {3.0, 2.0, 0.0}, 10 + i), {3.0, 2.0, 0.0}, i);
    EXPECT_NEAR(reading.seen, reading.expected, 0.05);
    EXPECT_FALSE(reading.low_since);
  }
}

TEST(Monitor, TellsSinceWhenAndByHowMuchScansAreLow) {
  Monitor monitor(map_of_the_room(), options());
  const Pose2 base{3.0, 2.0, 0.0};
  EXPECT_FALSE(monitor.update(seen(room(true), base, 1), base, 1.0).low_since);
  const MonitorReading first = monitor.update(seen(room(false), base, 2), base, 2.0);
  const MonitorReading second = monitor.update(seen(room(false), base, 3), base, 3.0);
  EXPECT_EQ(first.low_since, 2.0);
  EXPECT_EQ(second.low_since, 2.0);
  EXPECT_GT(first.lower, 0.1);
  EXPECT_DOUBLE_EQ(second.lower_in_mean, 0.5 * (first.lower + second.lower));
  EXPECT_FALSE(monitor.update(seen(room(true), base, 4), base, 4.0).low_since);
  EXPECT_EQ(monitor.update(seen(room(false), base, 5), base, 5.0).low_since, 5.0);
}

TEST(Monitor, AScanOffTheMapNeitherBeginsNorEndsARun) {
  Monitor monitor(map_of_the_room(), options());
  const Pose2 base{3.0, 2.0, 0.0}, off{-20.0, 2.0, 0.0};
  EXPECT_TRUE(std::isnan(monitor.update(seen(room(false), off, 1), off, 1.0).lower));
  EXPECT_EQ(monitor.update(seen(room(false), base, 2), base, 2.0).low_since, 2.0);
  EXPECT_FALSE(monitor.update(seen(room(false), off, 3), off, 3.0).low_since);
  EXPECT_EQ(monitor.update(seen(room(false), base, 4), base, 4.0).low_since, 2.0);
}

TEST(Monitor, ExpectsWhatTheMapSaysOfTheNearestHeading) {
  AlignabilityMap map = map_with(0.1f);
  for (int k = 0; k < 4; ++k) {
    map.layers.push_back({"alpha_heading_" + std::to_string(k), Grid<float>(map.geometry, 0.1f * static_cast<float>(k + 1))});
  }
  Monitor monitor(map, options());
  const auto expected = [&](double yaw) { return monitor.update({}, {3.0, 2.0, yaw}, 0.0).expected; };
  EXPECT_FLOAT_EQ(static_cast<float>(expected(0.1)), 0.1f);
  EXPECT_FLOAT_EQ(static_cast<float>(expected(-0.1)), 0.1f);
  EXPECT_FLOAT_EQ(static_cast<float>(expected(std::numbers::pi / 2.0)), 0.2f);
  EXPECT_FLOAT_EQ(static_cast<float>(expected(-std::numbers::pi / 2.0)), 0.4f);
  EXPECT_FLOAT_EQ(static_cast<float>(expected(7.0 * std::numbers::pi)), 0.3f);
}

TEST(Monitor, RefusesAMarginOutOfRange) {
  MonitorOptions wrong = options();
  wrong.margin = -0.1;
  EXPECT_THROW(Monitor(map_with(0.5f), wrong), std::invalid_argument);
  wrong.margin = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(Monitor(map_with(0.5f), wrong), std::invalid_argument);
  wrong = options();
  wrong.range_max = 0.0;
  EXPECT_THROW(Monitor(map_with(0.5f), wrong), std::invalid_argument);
}

// Within 2 m of the middle of the room there are two walls and the floor, but no ends.
TEST(Monitor, LooksNoFartherThanToldTo) {
  MonitorOptions near = options();
  near.range_max = 2.5;
  const Pose2 middle{3.0, 2.0, 0.0};
  const Scan scan = seen(room(true), middle, 1);
  EXPECT_LT(Monitor(map_with(0.5f), near).update(scan, middle, 0.0).seen,
            Monitor(map_with(0.5f), options()).update(scan, middle, 0.0).seen);
}

}  // namespace
}  // namespace alignability
