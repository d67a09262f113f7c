// SPDX-License-Identifier: BSD-3-Clause
// Drives and surveys with lidars that lean, several on one robot.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/pose.hpp"
#include "localization/fit_error_model.hpp"
#include "localization/survey.hpp"
#include "localization/trials.hpp"
#include "tests/alignability/simulated.hpp"

namespace alignability {
namespace {

using test::box;

// 8 × 6 m within walls, a block in one corner.
Scene room() {
  return Scene({box({0, 0, -0.1}, {8, 6, 0}), box({-0.2, 0, 0}, {0, 6, 3}), box({8, 0, 0}, {8.2, 6, 3}), box({0, -0.2, 0}, {8, 0, 3}),
                box({0, 6, 0}, {8, 6.2, 3}), box({6, 4, 0}, {7, 5, 3})});
}

OccupancyMap all_free() { return OccupancyMap(Grid<float>({.resolution = 0.5, .origin = {0.0, 0.0}, .width = 16, .height = 12}, 0.0f)); }

// One looks ahead, one back, each leaning down.
SensorRig leaning() {
  LidarModel ahead = test::hdl32e();
  ahead.sectors = {{.min = radians(-60), .max = radians(60), .columns = 121}};
  LidarModel back = ahead;
  ahead.T_base_lidar = Eigen::Translation3d(0.4, 0.1, 1.9) * Eigen::AngleAxisd(radians(15), Eigen::Vector3d::UnitY());
  back.T_base_lidar = Eigen::Translation3d(-0.4, -0.1, 1.6) * Eigen::AngleAxisd(radians(180), Eigen::Vector3d::UnitZ()) *
                      Eigen::AngleAxisd(radians(15), Eigen::Vector3d::UnitY());
  SensorRig rig = ahead;
  rig.lidars.push_back(back);
  return rig;
}

TEST(RigSurvey, PutsWhatLeaningLidarsSeeOnItsSurfaces) {
  const auto cloud = survey(room(), all_free(), leaning(), {.spacing = 2.0});
  ASSERT_GT(cloud.size(), 1000u);
  for (const Eigen::Vector3f& point : cloud) {
    const float wall = std::min({std::abs(point.x()), std::abs(point.x() - 8), std::abs(point.y()), std::abs(point.y() - 6)});
    const bool on_block = point.x() > 5.9f && point.x() < 7.1f && point.y() > 3.9f && point.y() < 5.1f;
    EXPECT_TRUE(std::abs(point.z()) < 0.05f || wall < 0.05f || on_block) << point.transpose();
  }
}

TEST(RigDrive, FindsItsWayByLeaningLidars) {
  const Scene scene = room();
  DriveOptions options{.odometry = {.scale_bias = 0.04}, .localizers = {Localizer::scan_matching}};
  const LocalizationMap map(survey(scene, all_free(), leaning(), {.spacing = 1.0}), options.localizer, options.localizers);
  const std::vector<Pose2> path{{2.0, 3.0, 0.0}, {5.0, 3.0, 0.0}, {5.0, 3.0, 1.5}};
  const Drive samples = drive(scene, leaning(), map, path, options, 1, {});
  for (const DriveSample& sample : samples) {
    if (sample.truth.seconds > 1.0) {
      EXPECT_LT(sample.error(0), 0.1) << sample.truth.seconds;
    }
  }
}

TEST(RigCalibration, NamesTheRigAndItsLargestNoise) {
  SensorRig rig = leaning();
  rig.name = "two";
  rig.lidars[1].range_stddev = 0.03;
  const Calibration calibration = calibration_of({}, 0, rig, std::nullopt);
  EXPECT_EQ(calibration.sensor, "two");
  EXPECT_EQ(calibration.noise, 0.03);
}

}  // namespace
}  // namespace alignability
