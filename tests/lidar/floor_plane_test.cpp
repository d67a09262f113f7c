// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/floor_plane.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "lidar/sample_surface.hpp"
#include "tests/lidar/fixtures.hpp"

namespace alignability {
namespace {

// A hall of 20 × 12 × 5 m with a table in it, its floor at z = 0.
std::vector<Eigen::Vector3f> hall() {
  return sample_surface({make_rectangle(20, 12), test::moved(make_rectangle(20, 12), 0, 0, 5),
                         test::moved(make_box({0.1, 12, 5}), 10, 0, 2.5), test::moved(make_box({2, 1, 0.1}), 3, 2, 0.8)},
                        {.spacing = 0.1, .stddev = 0.01})
      .points;
}

TEST(Leveled, TheLowestLargePlaneBecomesTheGround) {
  const Eigen::Isometry3d tilt(Eigen::Translation3d(0.3, -0.2, -1.5) * Eigen::AngleAxisd(0.1, Eigen::Vector3d(1, 2, 0).normalized()));
  std::vector<Eigen::Vector3f> points = hall();
  for (Eigen::Vector3f& point : points) point = (tilt * point.cast<double>()).cast<float>();
  const Eigen::Isometry3d T_map_points = leveled(points);
  EXPECT_TRUE(T_map_points.linear().isUnitary(1e-9));
  EXPECT_NEAR(T_map_points.linear().determinant(), 1.0, 1e-9);
  EXPECT_EQ((T_map_points.linear() * Eigen::Vector3d::UnitX()).y(), 0.0) << "x stays above x";
  const Eigen::Vector3d up = T_map_points.linear() * tilt.linear() * Eigen::Vector3d::UnitZ();
  EXPECT_GT(up.z(), std::cos(0.002));
  for (const Eigen::Vector3d& corner : {Eigen::Vector3d(-10, -6, 0), Eigen::Vector3d(10, -6, 0), Eigen::Vector3d(10, 6, 0)}) {
    EXPECT_NEAR((T_map_points * tilt * corner).z(), 0.0, 0.01);
  }
  const Eigen::Vector3d beneath = T_map_points.inverse() * Eigen::Vector3d::Zero();
  EXPECT_NEAR(beneath.head<2>().norm(), 0.0, 1e-9) << "the frame's origin is right above the map's";
}

TEST(Leveled, SaysTheSameOfTheSamePoints) {
  const std::vector<Eigen::Vector3f> points = hall();
  EXPECT_EQ(leveled(points).matrix(), leveled(points).matrix());
}

TEST(Leveled, WallsAndTooFewPointsAreRefused) {
  std::vector<Eigen::Vector3f> wall = sample_surface({make_rectangle(20, 12)}, {.spacing = 0.1}).points;
  for (Eigen::Vector3f& point : wall) point = {0.0f, point.x(), point.y()};
  EXPECT_THROW(leveled(wall), std::invalid_argument);
  EXPECT_THROW(leveled({}), std::invalid_argument);
}

}  // namespace
}  // namespace alignability
