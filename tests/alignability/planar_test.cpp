// SPDX-License-Identifier: BSD-3-Clause
// Scans of one level ring: lines for planes.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "alignability/alignability.hpp"
#include "alignability/explanation.hpp"
#include "core/pose.hpp"
#include "tests/alignability/simulated.hpp"

namespace alignability {
namespace {

using test::box;

LidarModel scanner(double stddev) {
  LidarModel lidar;
  lidar.name = "scanner";
  lidar.elevations = {0.0};
  lidar.sectors = {{.min = radians(-180), .max = radians(180), .columns = 1440}};
  lidar.range_min = 0.1;
  lidar.range_max = 30.0;
  lidar.range_stddev = stddev;
  lidar.rate = 25.0;
  lidar.T_base_lidar.translation().z() = 0.2;
  return lidar;
}

// Four walls about the origin.
std::vector<TriangleMesh> room(double length, double width) {
  const double x = 0.5 * length, y = 0.5 * width;
  return test::floor_and({box({x, -y, 0}, {x + 0.2, y, 3}), box({-x - 0.2, -y, 0}, {-x, y, 3}), box({-x, y, 0}, {x, y + 0.2, 3}),
                          box({-x, -y - 0.2, 0}, {x, -y, 3})});
}

Eigen::Isometry3d robot_at(double x, double y, double yaw) {
  return Eigen::Translation3d(x, y, 0.0) * Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ());
}

ScoredScan scored(const std::vector<TriangleMesh>& meshes, const SensorRig& sensor, const Eigen::Isometry3d& T_map_base,
                  AlignabilityOptions options = {}) {
  const Scan scan = simulate_rig_scan(Scene(meshes), sensor, T_map_base, {}, NoiseKey{.seed = 7});
  return score(scan, for_lidar(options, sensor));
}

double alpha(const std::vector<TriangleMesh>& meshes, const SensorRig& sensor, const Eigen::Isometry3d& T_map_base = robot_at(0, 0, 0)) {
  return scored(meshes, sensor, T_map_base).alignability.alpha;
}

TEST(PlanarScan, ASquareRoomScoresOneAndACorridorNothing) {
  EXPECT_GT(alpha(room(8, 8), scanner(0.0)), 0.97);
  LidarModel near = scanner(0.0);
  near.range_max = 4.0;
  EXPECT_LT(alpha(test::plain_corridor(), near), 1e-6);
}

// Far down the corridor returns are so sparse that the neighbours of a point lie on both walls.
TEST(PlanarScan, OfACorridorSeenFarScoresNextToNothing) { EXPECT_LT(alpha(test::plain_corridor(), scanner(0.0)), 1e-3); }

TEST(PlanarScan, DoesSoWithNoiseToo) {
  for (const double stddev : {0.005, 0.015, 0.03}) {
    EXPECT_GT(alpha(room(8, 8), scanner(stddev)), 0.95) << stddev;
    EXPECT_LT(alpha(test::plain_corridor(), scanner(stddev)), 0.01) << stddev;
  }
}

TEST(PlanarScan, DoesNotDependOnTheRobotsHeading) {
  for (const double yaw : {0.3, 1.0, 2.5}) {
    EXPECT_GT(alpha(room(8, 8), scanner(0.0), robot_at(0, 0, yaw)), 0.97) << yaw;
    EXPECT_LT(alpha(test::plain_corridor(), scanner(0.0), robot_at(0, 0, yaw)), 1e-3) << yaw;
  }
}

TEST(PlanarScan, IsHeldLeastAlongTheCorridor) {
  const ScoredScan result = scored(test::plain_corridor(), scanner(0.01), robot_at(0, 0, 0.5));
  EXPECT_EQ(result.alignability.dimensions, 2);
  const Eigen::Vector3d in_map = robot_at(0, 0, 0.5).linear() * result.alignability.weakest_direction;
  EXPECT_NEAR(std::abs(in_map.x()), 1.0, 1e-3);
  EXPECT_EQ(in_map.z(), 0.0);
  EXPECT_TRUE(result.axes.col(1).isApprox(result.alignability.weakest_direction));
  EXPECT_NEAR(result.alignability.eigenvalues[0] + result.alignability.eigenvalues[1], 1.0, 1e-9);
  EXPECT_TRUE(std::isnan(result.alignability.eigenvalues[2]));
}

// Of a room of four walls α is the ratio of the points on the walls that face x to those that face y.
TEST(PlanarScan, CountsThePointsOfEachWall) {
  const double expected = std::atan(2.0 / 6.0) / (radians(90) - std::atan(2.0 / 6.0));
  EXPECT_NEAR(alpha(room(12, 4), scanner(0.0)), expected, 0.05);
}

TEST(PlanarScan, IsToldFromItsPointsWhereNoSensorIs) {
  const Scan scan = simulate_rig_scan(Scene(room(8, 8)), scanner(0.0), robot_at(0, 0, 0));
  EXPECT_EQ(score(scan, {}).alignability.dimensions, 2);
  EXPECT_EQ(score(scan, {}).alignability.alpha, score(scan, for_lidar({}, scanner(0.0))).alignability.alpha);
  EXPECT_EQ(score(test::scan_of(room(8, 8)), {}).alignability.dimensions, 3);
}

TEST(PlanarScan, AScannerUpsideDownSeesTheSame) {
  LidarModel turned = scanner(0.0);
  turned.T_base_lidar.rotate(Eigen::AngleAxisd(radians(180), Eigen::Vector3d::UnitX()));
  ASSERT_TRUE(turned.is_planar());
  EXPECT_NEAR(alpha(room(8, 8), turned), alpha(room(8, 8), scanner(0.0)), 1e-3);
  const ScoredScan result = scored(test::plain_corridor(), turned, robot_at(0, 0, 0.5));
  const Eigen::Vector3d in_map = robot_at(0, 0, 0.5).linear() * turned.T_base_lidar.linear() * result.alignability.weakest_direction;
  EXPECT_NEAR(std::abs(in_map.x()), 1.0, 1e-3);
}

TEST(PlanarScan, LooksIntoItsSectorAlone) {
  LidarModel forward = scanner(0.0);
  forward.sectors = {{.min = radians(-40), .max = radians(40), .columns = 321}};
  EXPECT_LT(alpha(room(8, 8), forward), 1e-6);
  EXPECT_GT(alpha(room(8, 8), forward, robot_at(0, 0, radians(45))), 0.9);
}

TEST(PlanarScan, ReadingsAreTakenInThePlane) {
  AlignabilityOptions options;
  options.readings = {Reading::centred, Reading::voxel, Reading::robust, Reading::information};
  const Readings square = scored(room(8, 8), scanner(0.01), robot_at(0, 0, 0), options).alignability.readings;
  EXPECT_GT(square.centred, 0.9);
  EXPECT_GT(square.voxel, 0.8);
  EXPECT_GT(square.robust, 0.95);
  EXPECT_GT(square.information.least, 1e6);
  const Readings corridor = scored(test::plain_corridor(), scanner(0.01), robot_at(0, 0, 0), options).alignability.readings;
  EXPECT_LT(corridor.robust, 1e-4);
  EXPECT_LT(corridor.information.least, 1e-3 * square.information.least);
}

TEST(PlanarScan, IsExplainedByWalls) {
  const LidarModel lidar = scanner(0.01);
  const Scan scan = simulate_rig_scan(Scene(test::plain_corridor()), lidar, robot_at(0, 0, 0), {}, NoiseKey{.seed = 7});
  const Explanation explanation = explain(scan, Eigen::Matrix3d::Identity(), lidar.range_stddev, for_lidar({}, lidar));
  ASSERT_EQ(explanation.planes.size(), 2u);
  for (const ExplainedPlane& plane : explanation.planes) {
    EXPECT_EQ(plane.kind, PlaneKind::wall);
    EXPECT_NEAR(plane.distance, 1.5, 0.01);
    EXPECT_EQ(plane.extents[2], 0.0);
  }
  EXPECT_NEAR(explanation.weakest_axis().x(), 1.0, 1e-3);
  EXPECT_EQ(weakest_text(explanation), "along x");
}

TEST(PlanarScan, OfASquareRoomIsHeldInEveryDirectionAlike) {
  const LidarModel lidar = scanner(0.0);
  const Scan scan = simulate_rig_scan(Scene(room(8, 8)), lidar, robot_at(0, 0, 0));
  const Explanation explanation = explain(scan, Eigen::Matrix3d::Identity(), 0.0, for_lidar({}, lidar));
  EXPECT_EQ(weakest_text(explanation), "in every direction alike");
}

TEST(PlanarScan, PclKnowsNone) {
  AlignabilityOptions options = for_lidar({}, scanner(0.0));
  options.segmentation.engine = Engine::pcl;
  EXPECT_THROW(Scorer{options}, std::invalid_argument);
}

TEST(PlanarScan, OfNothingScoresNothing) {
  const SensorRig sensor = scanner(0.0);
  EXPECT_EQ(alpha(test::floor_and({}), sensor), 0.0);
}

}  // namespace
}  // namespace alignability
