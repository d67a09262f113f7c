// SPDX-License-Identifier: BSD-3-Clause
// Lidars of one robot scored together, and mounts that lean.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "alignability/build_map.hpp"
#include "alignability/checkpoint.hpp"
#include "alignability/explanation.hpp"
#include "core/pose.hpp"
#include "tests/alignability/simulated.hpp"
#include "tests/costmap/ascii_map.hpp"

namespace alignability {
namespace {

using test::box;

LidarModel lidar_of(double from_deg, double to_deg, int columns) {
  LidarModel lidar = test::hdl32e();
  lidar.sectors = {{.min = radians(from_deg), .max = radians(to_deg), .columns = columns}};
  return lidar;
}

SensorRig both(const LidarModel& a, const LidarModel& b) {
  SensorRig rig = a;
  rig.lidars.push_back(b);
  return rig;
}

// A hall with walls ahead and on the left alone.
std::vector<TriangleMesh> two_walls() { return test::floor_and({box({4, -9, 0}, {4.2, 9, 5}), box({-9, 4, 0}, {9, 4.2, 5})}); }

Scan seen(const std::vector<TriangleMesh>& meshes, const SensorRig& rig, std::optional<NoiseKey> noise = std::nullopt) {
  return simulate_rig_scan(Scene(meshes), rig, Eigen::Isometry3d::Identity(), {.range_max = 6.5}, noise);
}

double alpha(const std::vector<TriangleMesh>& meshes, const SensorRig& rig) {
  return score(seen(meshes, rig), for_lidar({}, rig)).alignability.alpha;
}

TEST(SensorRigScore, LidarsHoldTogetherWhatNoneHoldsAlone) {
  const LidarModel ahead = lidar_of(-40, 40, 482);
  LidarModel left = ahead;
  left.T_base_lidar.rotate(Eigen::AngleAxisd(radians(90), Eigen::Vector3d::UnitZ()));
  EXPECT_LT(alpha(two_walls(), ahead), 0.02);
  EXPECT_LT(alpha(two_walls(), left), 0.02);
  EXPECT_GT(alpha(two_walls(), both(ahead, left)), 0.2);
}

TEST(SensorRigScore, TwoHalvesScoreAsTheWhole) {
  const SensorRig halves = both(lidar_of(-180, -0.166, 1085), lidar_of(0, 179.834, 1085));
  EXPECT_NEAR(alpha(two_walls(), halves), alpha(two_walls(), test::hdl32e()), 0.02);
}

TEST(SensorRigScore, ARigOfOneScoresAsItsLidarToTheBit) {
  const NoiseKey noise{.seed = 3};
  const LidarModel lidar = test::hdl32e();
  const Scan alone = simulate_scan(Scene(two_walls()), lidar, lidar.T_base_lidar, {.range_max = 6.5}, noise);
  EXPECT_EQ(score(alone, {}).alignability.alpha, score(seen(two_walls(), lidar, noise), for_lidar({}, lidar)).alignability.alpha);
}

TEST(SensorRigScore, NormalsAreFoundWithinEachLidarsOwnScan) {
  const LidarModel lidar = lidar_of(-40, 40, 482);
  const SensorRig twice = both(lidar, lidar);
  const ScoredScan one = score(seen(two_walls(), lidar), for_lidar({}, lidar));
  const ScoredScan two = score(seen(two_walls(), twice), for_lidar({}, twice));
  ASSERT_EQ(two.normals.size(), 2 * one.normals.size());
  EXPECT_EQ(two.alignability.planes_kept, 2 * one.alignability.planes_kept);
  EXPECT_NEAR(two.alignability.alpha, one.alignability.alpha, 1e-4);
}

TEST(SensorRigScore, APlaneThatTwoLidarsSeeIsExplainedAsOne) {
  LidarModel higher = lidar_of(-40, 40, 482);
  higher.T_base_lidar.translation() << 0.5, 0.0, 2.2;
  const SensorRig rig = both(lidar_of(-40, 40, 482), higher);
  const Explanation explanation = explain(seen(two_walls(), rig), Eigen::Matrix3d::Identity(), 0.008, for_lidar({}, rig));
  ASSERT_GE(explanation.planes.size(), 2u);  // and the edge between them
  const ExplainedPlane& wall = explanation.planes[0];
  EXPECT_EQ(wall.kind, PlaneKind::wall);
  EXPECT_NEAR(wall.normal.x(), -1.0, 1e-3);
  EXPECT_TRUE(std::abs(wall.distance - 4.0) < 0.02 || std::abs(wall.distance - 3.5) < 0.02) << wall.distance;
  const ExplainedPlane& floor = explanation.planes[1];
  EXPECT_EQ(floor.kind, PlaneKind::floor);
  EXPECT_TRUE(std::abs(floor.distance - 1.9) < 0.02 || std::abs(floor.distance - 2.2) < 0.02) << floor.distance;
  for (std::size_t i = 2; i < explanation.planes.size(); ++i) EXPECT_LT(explanation.planes[i].share, 0.02);
}

TEST(SensorRigScore, ReadingsAreOfAllLidars) {
  AlignabilityOptions options;
  options.readings = {Reading::voxel, Reading::robust, Reading::information};
  const LidarModel ahead = lidar_of(-40, 40, 482);
  LidarModel left = ahead;
  left.T_base_lidar.rotate(Eigen::AngleAxisd(radians(90), Eigen::Vector3d::UnitZ()));
  const auto readings = [&](const SensorRig& rig) { return score(seen(two_walls(), rig), for_lidar(options, rig)).alignability.readings; };
  const Readings alone = readings(ahead), together = readings(both(ahead, left));
  EXPECT_GT(together.voxel, alone.voxel + 0.1);
  EXPECT_GT(together.robust, alone.robust + 0.1);
  EXPECT_GT(together.information.least, 10.0 * alone.information.least + 1.0);
}

// Leaning, the lidar still says where the corridor leads: its frame leans, that of the map does not.
TEST(TiltedMount, MapHasTheWeakAxisAlongTheCorridor) {
  LidarModel lidar = test::hdl32e();
  lidar.sectors.front().columns = 720;
  lidar.T_base_lidar.rotate(Eigen::AngleAxisd(radians(25), Eigen::Vector3d(0.3, 1.0, 0.2).normalized()));
  MapOptions options;
  options.samples = 2;
  options.range_max = 6.5;
  options.alignability = for_lidar({}, lidar);
  const OccupancyMap occupancy = test::ascii_map(1.0, {"."});
  const AlignabilityMap map = build_alignability_map(Scene(test::plain_corridor()), occupancy, lidar, options);
  const Eigen::Vector3d weak((*map.find_layer("weak_x"))[0], (*map.find_layer("weak_y"))[0], (*map.find_layer("weak_z"))[0]);
  EXPECT_GT(std::abs(weak.x()), 0.99);
}

TEST(TiltedMount, IsToldFloorFromWall) {
  LidarModel lidar = test::hdl32e();
  lidar.T_base_lidar.rotate(Eigen::AngleAxisd(radians(25), Eigen::Vector3d::UnitY()));
  const Explanation explanation =
      explain(seen(test::plain_corridor(), lidar), lidar.T_base_lidar.linear(), lidar.range_stddev, for_lidar({}, lidar));
  int floors = 0, walls = 0;
  for (const ExplainedPlane& plane : explanation.planes) {
    floors += plane.kind == PlaneKind::floor ? 1 : 0;
    walls += plane.kind == PlaneKind::wall ? 1 : 0;
    if (plane.kind == PlaneKind::floor) {
      EXPECT_NEAR(plane.distance, 1.9, 0.02);
    }
  }
  EXPECT_EQ(floors, 1);
  EXPECT_EQ(walls, 2);
}

TEST(SensorRigMap, IsBuiltAndTellsOneRigFromAnother) {
  const LidarModel ahead = lidar_of(-40, 40, 482);
  LidarModel left = ahead;
  left.T_base_lidar.rotate(Eigen::AngleAxisd(radians(90), Eigen::Vector3d::UnitZ()));
  const SensorRig rig = both(ahead, left);
  MapOptions options;
  options.samples = 2;
  options.range_max = 6.5;
  options.alignability = for_lidar({}, rig);
  const Scene scene(two_walls());
  const OccupancyMap occupancy = test::ascii_map(1.0, {"."});
  const auto alpha = [&](const SensorRig& sensor) { return build_alignability_map(scene, occupancy, sensor, options).alpha()[0]; };
  EXPECT_GT(alpha(rig), 5.0f * std::max(alpha(ahead), alpha(left)));
  const auto print = [&](const SensorRig& sensor) { return detail::fingerprint(scene, occupancy, sensor, "", 1); };
  EXPECT_NE(print(rig), print(ahead));
  EXPECT_NE(print(rig), print(both(left, ahead)));
  LidarModel turned = ahead;
  turned.azimuth_offsets.assign(32, 0.01);
  EXPECT_NE(print(turned), print(ahead));
}

}  // namespace
}  // namespace alignability
