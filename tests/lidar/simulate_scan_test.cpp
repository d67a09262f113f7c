// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/simulate_scan.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <thread>

#include "lidar/primitives.hpp"
#include "tests/lidar/fixtures.hpp"

namespace alignability {
namespace {

using test::moved;
using test::small_lidar;

// Looked at from within: a room of the given size about the origin.
Scene room(double x, double y, double z) { return Scene({make_box({x, y, z})}); }

Eigen::Isometry3d at(double x, double y, double z, double yaw) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = Eigen::Vector3d(x, y, z);
  pose.rotate(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()));
  return pose;
}

bool same(const Scan& a, const Scan& b) {
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    const bool both_nan = a.points[i].array().isNaN().all() && b.points[i].array().isNaN().all();
    if (!both_nan && a.points[i] != b.points[i]) return false;
  }
  return a.points.size() == b.points.size();
}

TEST(SimulateScan, IsOrganizedRingByRing) {
  const Scan scan = simulate_scan(room(10, 8, 6), small_lidar(), at(0, 0, 0, 0));
  EXPECT_EQ(scan.rings, 3);
  EXPECT_EQ(scan.columns, 12);
  ASSERT_EQ(scan.points.size(), 36u);
  EXPECT_TRUE(scan.organized());
  EXPECT_TRUE(scan.points[12 + 6].isApprox(Eigen::Vector3f(5, 0, 0), 1e-5f));
  EXPECT_TRUE(scan.points[12 + 9].isApprox(Eigen::Vector3f(0, 4, 0), 1e-5f));
}

TEST(SimulateScan, PointsLieOnTheWallsOnceMovedToTheMap) {
  const Eigen::Isometry3d T_map_lidar = at(1.5, -2, 0.5, 0.7) * Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitX());
  const Scan scan = simulate_scan(room(10, 8, 6), small_lidar(), T_map_lidar);
  for (const Eigen::Vector3f& point : scan.points) {
    const Eigen::Vector3d off = (T_map_lidar * point.cast<double>()).cwiseAbs() - Eigen::Vector3d(5, 4, 3);
    EXPECT_NEAR(off.maxCoeff(), 0.0, 1e-5);
  }
}

TEST(SimulateScan, RangesOutsideTheLimitsAreNan) {
  LidarModel model = small_lidar();
  model.range_max = 4.5;
  const Scan far = simulate_scan(room(10, 8, 6), model, at(0, 0, 0, 0));
  EXPECT_TRUE(std::isnan(far.points[12 + 6].x()));
  EXPECT_NEAR(far.points[12 + 9].y(), 4.0f, 1e-5f);

  const Scan cropped = simulate_scan(room(10, 8, 6), small_lidar(), at(0, 0, 0, 0), {.range_max = 3.9});
  EXPECT_TRUE(std::isnan(cropped.points[12 + 9].y()));

  model.range_min = 4.2;
  EXPECT_TRUE(std::isnan(simulate_scan(room(10, 8, 6), model, at(0, 0, 0, 0)).points[12 + 9].y()));
}

TEST(SimulateScan, RefusesALimitWithinWhichTheLidarSeesNothing) {
  LidarModel model = small_lidar();
  model.range_min = 1.0;
  const auto cropped = [&](double range_max) { simulate_scan(room(10, 8, 6), model, at(0, 0, 0, 0), {.range_max = range_max}); };
  EXPECT_THROW(cropped(1.0), std::invalid_argument);
  EXPECT_THROW(cropped(std::nan("")), std::invalid_argument);
  EXPECT_NO_THROW(cropped(1.1));
}

TEST(SimulateScan, NoiseHasTheDeviationOfTheSensorAndLiesAlongTheBeam) {
  LidarModel model = small_lidar();
  model.sectors.front().columns = 20000;
  model.elevations = {0.1};
  model.range_stddev = 0.02;
  const Scene sphere({make_sphere(5)});
  const Scan clean = simulate_scan(sphere, model, at(0, 0, 0, 0));
  const Scan noisy = simulate_scan(sphere, model, at(0, 0, 0, 0), {}, NoiseKey{1, 2, 3});
  double sum = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < clean.points.size(); ++i) {
    const double error = noisy.points[i].norm() - clean.points[i].norm();
    EXPECT_NEAR(noisy.points[i].normalized().dot(clean.points[i].normalized()), 1.0, 1e-5);
    sum += error;
    squares += error * error;
  }
  const double mean = sum / model.columns();
  EXPECT_NEAR(mean, 0.0, 5 * 0.02 / std::sqrt(20000));
  EXPECT_NEAR(std::sqrt(squares / model.columns() - mean * mean), 0.02, 0.0006);
}

TEST(SimulateScan, TheSameKeyGivesTheSameNoiseOnAnyThread) {
  LidarModel model = small_lidar();
  model.range_stddev = 0.01;
  const Scene scene = room(10, 8, 6);
  const Scan here = simulate_scan(scene, model, at(0, 0, 0, 0), {}, NoiseKey{1, 2, 3});
  Scan there;
  std::thread([&] { there = simulate_scan(scene, model, at(0, 0, 0, 0), {}, NoiseKey{1, 2, 3}); }).join();
  EXPECT_TRUE(same(here, there));
}

TEST(SimulateScan, EveryWordOfTheKeyCounts) {
  LidarModel model = small_lidar();
  model.range_stddev = 0.01;
  const Scene scene = room(10, 8, 6);
  const auto scan = [&](const NoiseKey& key) { return simulate_scan(scene, model, at(0, 0, 0, 0), {}, key); };
  const Scan reference = scan({1, 2, 3});
  for (const NoiseKey& key : {NoiseKey{2, 2, 3}, NoiseKey{1, 3, 3}, NoiseKey{1, 2, 4}, NoiseKey{1ull << 32 | 1, 2, 3}, NoiseKey{2, 1, 3}}) {
    EXPECT_FALSE(same(reference, scan(key)));
  }
}

TEST(SimulateScan, NoiseOfABeamDoesNotDependOnWhatOthersHit) {
  LidarModel model = small_lidar();
  model.range_stddev = 0.01;
  const Scene whole({moved(make_box({1, 20, 20}), 5, 0, 0), moved(make_box({1, 20, 20}), -5, 0, 0)});
  const Scene half({moved(make_box({1, 20, 20}), 5, 0, 0)});
  const Scan a = simulate_scan(whole, model, at(0, 0, 0, 0), {}, NoiseKey{});
  const Scan b = simulate_scan(half, model, at(0, 0, 0, 0), {}, NoiseKey{});
  EXPECT_TRUE(std::isnan(b.points[12].x()));
  EXPECT_FALSE(std::isnan(a.points[12].x()));
  EXPECT_EQ(a.points[12 + 6], b.points[12 + 6]);
}

TEST(SimulateScan, NeedsAFinitePose) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(simulate_scan(room(20, 20, 20), small_lidar(), at(nan, 0, 0, 0)), std::invalid_argument);
  EXPECT_THROW(simulate_scan(room(20, 20, 20), small_lidar(), at(0, 0, 0, nan)), std::invalid_argument);
}

// The stream of random numbers is part of what makes maps repeat: on another machine it must be this one.
TEST(SimulateScan, NoiseIsTheSameOnEveryMachine) {
  LidarModel model = small_lidar();
  model.range_stddev = 1.0;
  const Scan noisy = simulate_scan(room(20, 20, 20), model, at(0, 0, 0, 0), {}, NoiseKey{1, 2, 3});
  const Scan clean = simulate_scan(room(20, 20, 20), model, at(0, 0, 0, 0));
  EXPECT_NEAR(noisy.points[18].x() - clean.points[18].x(), 1.63666, 1e-4);
}

}  // namespace
}  // namespace alignability
