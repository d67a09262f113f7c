// SPDX-License-Identifier: BSD-3-Clause
// Drives with a 2D scanner, mounted so low that a 3D localizer would take all it sees for the floor.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/pose.hpp"
#include "localization/drive.hpp"
#include "localization/survey.hpp"
#include "tests/alignability/simulated.hpp"

namespace alignability {
namespace {

using test::box;

LidarModel scanner() {
  LidarModel lidar;
  lidar.elevations = {0.0};
  lidar.sectors = {{.min = radians(-135), .max = radians(135), .columns = 541}};
  lidar.range_min = 0.1;
  lidar.range_max = 10.0;
  lidar.range_stddev = 0.01;
  lidar.rate = 10.0;
  lidar.T_base_lidar.translation().z() = 0.15;
  return lidar;
}

// Around the origin; its ends far out of sight where it is long.
std::vector<TriangleMesh> room(double length, double width) {
  const double x = 0.5 * length, y = 0.5 * width;
  return test::floor_and({box({x, -y, 0}, {x + 0.2, y, 3}), box({-x - 0.2, -y, 0}, {-x, y, 3}), box({-x, y, 0}, {x, y + 0.2, 3}),
                          box({-x, -y - 0.2, 0}, {x, -y, 3})});
}

OccupancyMap free_ground(double length, double width) {
  return OccupancyMap(Grid<float>({.resolution = 0.5,
                                   .origin = {-0.5 * length, -0.5 * width},
                                   .width = static_cast<int>(2.0 * length),
                                   .height = static_cast<int>(2.0 * width)},
                                  0.0f));
}

// With odometry that reports 4 % too much.
Drive driven(double length, double width, const std::vector<Pose2>& path) {
  const Scene scene(room(length, width));
  DriveOptions options{.odometry = {.scale_bias = 0.04},
                       .localizers = {Localizer::ndt_mcl_sum, Localizer::ndt_mcl_product, Localizer::scan_matching}};
  const auto cloud = survey(scene, free_ground(length, width), scanner(), {.spacing = 1.0});
  const LocalizationMap map(cloud, for_sensor(options.localizer, scanner()), options.localizers);
  return drive(scene, scanner(), map, path, options, 1, {});
}

TEST(PlanarDrive, HoldsInASquareRoom) {
  for (const DriveSample& sample : driven(8.0, 8.0, {{-2.0, -1.0, 0.0}, {2.0, -1.0, 0.0}, {2.0, -1.0, 1.5}, {2.0, 2.0, 1.5}})) {
    if (sample.truth.seconds < 2.0) continue;
    for (std::size_t localizer = 0; localizer < 3; ++localizer)
      EXPECT_LT(sample.error(localizer), 0.1) << localizer << ' ' << sample.truth.seconds;
  }
}

TEST(PlanarDrive, DriftsAlongAPlainCorridorAsItsOdometryDoesAndNotAcross) {
  const DriveSample last = driven(80.0, 3.0, {{-10.0, 0.0, 0.0}, {10.0, 0.0, 0.0}}).back();
  for (std::size_t localizer = 0; localizer < 3; ++localizer) {
    EXPECT_NEAR(last.estimates[localizer].x - last.truth.pose.x, 0.04 * 20.0, 0.5) << localizer;
    EXPECT_GT(last.error(localizer), 0.3) << localizer;
    EXPECT_NEAR(last.estimates[localizer].y, 0.0, 0.05) << localizer;
  }
}

TEST(PlanarNdt, TakesNoHeedOfHeight) {
  std::vector<Eigen::Vector3f> wall, straddling;
  for (int i = 0; i < 20; ++i) {
    wall.emplace_back(0.01f * static_cast<float>(i), 0.001f * static_cast<float>(i % 3), 0.0f);
    straddling.push_back(wall.back() + Eigen::Vector3f(0.0f, 0.0f, i % 2 == 0 ? 0.3999999f : 0.4f));
  }
  const NdtOptions squares{.shape = NdtCells::squares};
  const Ndt flat(wall, squares), raised(straddling, squares);
  ASSERT_EQ(raised.cells().size(), 1u);
  EXPECT_TRUE(raised.cells()[0].covariance.isApprox(flat.cells()[0].covariance));
  EXPECT_EQ(raised.find({0.05, 0.0, 7.0}), &raised.cells()[0]);
  EXPECT_EQ(Ndt(straddling, {}).cells().size(), 2u);
}

}  // namespace
}  // namespace alignability
