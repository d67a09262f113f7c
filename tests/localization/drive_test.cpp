// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <stdexcept>

#include "localization/survey.hpp"
#include "localization/trials.hpp"
#include "tests/alignability/simulated.hpp"

namespace alignability {
namespace {

using test::box;

TEST(PosesAlong, KeepSpeedAndPeriodAndEndAtTheEnd) {
  const std::vector<Pose2> path{{0.0, 0.0, 0.0}, {3.0, 0.0, 0.0}, {3.0, 4.0, 0.0}};
  const auto poses = poses_along(path, {.speed = 2.0, .turn_rate = 1.0}, 0.1);
  EXPECT_EQ(poses.front().pose, path.front());
  EXPECT_EQ(poses.back().pose, path.back());
  EXPECT_NEAR(poses.back().seconds, 3.5, 1e-12);
  EXPECT_NEAR(poses.back().s, 7.0, 1e-12);
  EXPECT_EQ(poses.size(), 36u);
  for (std::size_t i = 1; i + 1 < poses.size(); ++i) {
    EXPECT_NEAR(poses[i].seconds, 0.1 * static_cast<double>(i), 1e-12);
    EXPECT_NEAR(poses[i].s, 2.0 * poses[i].seconds, 1e-9);
  }
}

TEST(PosesAlong, TakeTheirTimeToTurnOnTheSpot) {
  const std::vector<Pose2> path{{0.0, 0.0, 0.0}, {0.0, 0.0, std::numbers::pi / 2}, {1.0, 0.0, std::numbers::pi / 2}};
  const auto poses = poses_along(path, {.speed = 1.0, .turn_rate = 0.5}, 0.1);
  EXPECT_NEAR(poses.back().seconds, std::numbers::pi + 1.0, 1e-12);
  EXPECT_NEAR(poses[10].pose.yaw, 0.5, 1e-9);
  EXPECT_EQ(poses[10].s, 0.0);
}

TEST(PosesAlong, OfOnePoseOrNoneAreAsMany) {
  EXPECT_TRUE(poses_along({}, {}, 0.1).empty());
  EXPECT_EQ(poses_along(std::vector<Pose2>{{1.0, 2.0, 3.0}}, {}, 0.1).size(), 1u);
}

TEST(PosesAlong, RefuseToStandStill) {
  EXPECT_THROW(poses_along({}, {.speed = 0.0}, 0.1), std::invalid_argument);
  EXPECT_THROW(poses_along({}, {.turn_rate = -1.0}, 0.1), std::invalid_argument);
  EXPECT_THROW(poses_along({}, {}, 0.0), std::invalid_argument);
}

// A room rich in surfaces at one end of a plain corridor, 40 m long.
Scene room_and_corridor() {
  return Scene({box({-8.0, -6.0, -0.1}, {42.0, 6.0, 0.0}), box({-8.2, -5.0, 0.0}, {-8.0, 5.0, 3.0}), box({-8.0, 5.0, 0.0}, {0.0, 5.2, 3.0}),
                box({-8.0, -5.2, 0.0}, {0.0, -5.0, 3.0}), box({0.0, 1.5, 0.0}, {0.2, 5.0, 3.0}), box({0.0, -5.0, 0.0}, {0.2, -1.5, 3.0}),
                box({0.0, 1.5, 0.0}, {40.0, 1.7, 3.0}), box({0.0, -1.7, 0.0}, {40.0, -1.5, 3.0}), box({-6.5, 2.0, 0.0}, {-5.5, 3.5, 2.5}),
                box({-3.0, -4.0, 0.0}, {-2.0, -3.0, 2.5})});
}

OccupancyMap all_free() { return OccupancyMap(Grid<float>({.resolution = 0.5, .origin = {-8.0, -5.0}, .width = 96, .height = 20}, 0.0f)); }

LidarModel coarse_lidar() {
  LidarModel model = test::hdl32e();
  model.sectors.front().columns = 720;
  return model;
}

// Into the corridor at 4 % bias, with each localizer.
Drive driven(std::uint64_t seed, double to) {
  const Scene scene = room_and_corridor();
  const LidarModel lidar = coarse_lidar();
  DriveOptions options{.pace = {.speed = 1.5}, .odometry = {.scale_bias = 0.04}, .range_max = 6.5};
  options.localizers = {Localizer::ndt_mcl_product, Localizer::scan_matching};
  const LocalizationMap map(survey(scene, all_free(), lidar, {.spacing = 2.0, .range_max = 6.5}), options.localizer, options.localizers);
  const std::vector<Pose2> path{{-4.0, 0.0, 0.0}, {to, 0.0, 0.0}};
  return drive(scene, lidar, map, path, options, seed, {});
}

TEST(Drive, LosesItsWayInTheCorridorAndNotInTheRoomWithEachLocalizer) {
  const Drive samples = driven(1, 28.0);
  for (const std::size_t localizer : {0u, 1u}) {
    double in_room = 0.0;
    for (const DriveSample& sample : samples) {
      if (sample.truth.pose.x < -1.0 && sample.truth.seconds > 1.0) in_room = std::max(in_room, sample.error(localizer));
    }
    EXPECT_LT(in_room, 0.1);
    EXPECT_GT(samples.back().error(localizer), 0.3) << "some 20 m of it show nothing along the way, at a bias of 4 %";
    EXPECT_LT(samples.back().error(localizer), 2.0);
  }
}

TEST(Drive, GoesAlikeWithTheSameSeedAndOtherwiseWithAnother) {
  const Drive first = driven(1, -1.0), again = driven(1, -1.0), other = driven(2, -1.0);
  ASSERT_EQ(first.size(), again.size());
  for (std::size_t i = 0; i < first.size(); ++i) EXPECT_EQ(first[i].estimates, again[i].estimates);
  EXPECT_NE(first.back().estimates, other.back().estimates);
}

const std::vector<Localizer> kSum{Localizer::ndt_mcl_sum};

TEST(Trials, AreTheDrivesOfTheirSeedsForAnyNumberOfThreads) {
  const Scene scene = room_and_corridor();
  LidarModel lidar = coarse_lidar();
  lidar.sectors.front().columns = 180;
  const LocalizationMap map(survey(scene, all_free(), lidar, {.spacing = 2.0, .range_max = 6.5}), {}, kSum);
  const std::vector<std::vector<Pose2>> paths{{{-4.0, 0.0, 0.0}, {-2.0, 0.0, 0.0}}, {{-4.0, 2.0, 0.0}, {-4.0, -2.0, 0.0}}};
  TrialOptions options{.drive = {.range_max = 6.5}, .runs = 3, .seed = 5, .threads = 2};
  std::size_t told = 0;
  options.progress = [&](Progress progress) { told = progress.done; };
  const auto drives = drive_trials(scene, lidar, map, paths, options);
  EXPECT_EQ(told, 6u);
  ASSERT_EQ(drives.size(), 2u);
  ASSERT_EQ(drives[1].size(), 3u);
  const Drive alone = drive(scene, lidar, map, paths[1], options.drive, 7, {});
  ASSERT_EQ(drives[1][2].size(), alone.size());
  for (std::size_t i = 0; i < alone.size(); ++i) EXPECT_EQ(drives[1][2][i].estimates, alone[i].estimates);
  options.runs = 0;
  EXPECT_THROW(drive_trials(scene, lidar, map, paths, options), std::invalid_argument);
}

TEST(Trials, StopWhenAsked) {
  std::stop_source stop;
  stop.request_stop();
  const Scene scene = room_and_corridor();
  const LocalizationMap map({}, {}, kSum);
  const std::vector<std::vector<Pose2>> paths{{{-4.0, 0.0, 0.0}, {-2.0, 0.0, 0.0}}};
  EXPECT_THROW(drive_trials(scene, coarse_lidar(), map, paths, {.drive = {}, .stop = stop.get_token()}), Interrupted);
}

TEST(Survey, SeesSurfacesFromWhereTheRobotCanBe) {
  const Scene scene({box({-5.0, -5.0, -0.1}, {5.0, 5.0, 0.0}), box({-5.2, -5.0, 0.0}, {-5.0, 5.0, 3.0})});
  const OccupancyMap occupancy(Grid<float>({.resolution = 0.5, .origin = {-5.0, -5.0}, .width = 20, .height = 20}, 0.0f));
  const auto cloud = survey(scene, occupancy, coarse_lidar(), {.spacing = 1.0, .thinning = 0.1});
  ASSERT_GT(cloud.size(), 1000u);
  for (const Eigen::Vector3f& point : cloud) {
    // The mean of a cube's points, which may be of the floor and of the wall.
    EXPECT_LT(std::min(std::abs(point.z()), std::abs(point.x() + 5.0f)), 0.1f) << point.transpose();
    EXPECT_GT(point.x(), -5.1f) << "the wall's far side";
  }
  EXPECT_THROW(survey(scene, occupancy, coarse_lidar(), {.spacing = 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace alignability
