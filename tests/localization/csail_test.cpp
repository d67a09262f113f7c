// SPDX-License-Identifier: BSD-3-Clause
// NDT-MCL along a recorded drive of a 2D lidar, against its corrected poses.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <numeric>

#include "core/distribution.hpp"
#include "core/pose.hpp"
#include "lidar/carmen_log.hpp"
#include "localization/localizer.hpp"
#include "localization/odometry.hpp"
#include "tests/shared_data.hpp"

namespace alignability {
namespace {

Pose2 pose_of(const PosedScan& scan) {
  const Eigen::Vector3d x = scan.T_map_lidar.linear().col(0);
  return {scan.T_map_lidar.translation().x(), scan.T_map_lidar.translation().y(), std::atan2(x.y(), x.x())};
}

Pose2 motion_between(const PosedScan& from, const PosedScan& to) {
  Pose2 start = pose_of(from), end = pose_of(to);
  const Eigen::Vector3d apart = from.T_map_lidar.inverse() * to.T_map_lidar.translation();
  return {apart.x(), apart.y(), normalized_angle(end.yaw - start.yaw)};
}

std::vector<Eigen::Vector3f> returns_of(const PosedScan& scan, const Eigen::Isometry3d& pose) {
  std::vector<Eigen::Vector3f> points;
  for (const Eigen::Vector3f& point : scan.scan->points) {
    if (point.allFinite()) points.push_back((pose * point.cast<double>()).cast<float>());
  }
  return points;
}

LidarModel level() {
  LidarModel lidar;
  lidar.elevations = {0.0};
  return lidar;
}

// Of every other scan; those between are driven.
LocalizationMap map_of(const std::vector<PosedScan>& scans, const LocalizerOptions& options, std::span<const Localizer> localizers) {
  std::vector<Eigen::Vector3f> cloud;
  for (std::size_t i = 0; i < scans.size(); i += 2) {
    const auto points = returns_of(scans[i], scans[i].T_map_lidar);
    cloud.insert(cloud.end(), points.begin(), points.end());
  }
  return LocalizationMap(cloud, options, localizers);
}

// Odometry is the corrected motion made 2 % too long, with noise.
std::vector<double> errors_of(Localizer which, const LocalizationMap& map, const std::vector<PosedScan>& scans,
                              const LocalizerOptions& options, std::uint64_t seed) {
  Odometry odometry({.scale_bias = 0.02, .position_noise = 0.02, .heading_noise = 0.01}, seed);
  RunningLocalizer localizer(which, map, pose_of(scans[1]), options, seed);
  std::vector<double> errors;
  for (std::size_t i = 1; i < scans.size(); i += 2) {
    if (i > 1) localizer.move(odometry.report(motion_between(scans[i - 2], scans[i])));
    const auto points = returns_of(scans[i], Eigen::Isometry3d::Identity());
    localizer.see(points, Ndt(points, options.ndt));
    errors.push_back((localizer.estimate().position() - pose_of(scans[i]).position()).norm());
  }
  return errors;
}

// On average to within a cell. The product is never lost; the sum, as published, strays farther than a metre in one of the five drives.
TEST(RecordedDrive, In2dIsFollowedByNdtMcl) {
  ALIGNABILITY_REQUIRE_SHARED_DATA(log, "logs/csail-2d/csail.corrected.log");
  constexpr std::array kBoth{Localizer::ndt_mcl_sum, Localizer::ndt_mcl_product};
  const std::vector<PosedScan> scans = read_carmen_log(log);
  const LocalizerOptions options = for_sensor({}, level());
  const LocalizationMap map = map_of(scans, options, kBoth);
  for (const Localizer which : kBoth) {
    std::vector<double> errors;
    for (std::uint64_t seed = 1; seed <= 5; ++seed)
      std::ranges::copy(errors_of(which, map, scans, options, seed), std::back_inserter(errors));
    std::ranges::sort(errors);
    const double mean = std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(errors.size());
    std::printf("%-16s mean %.3f m, 95 %% %.3f m, max %.3f m\n", to_string(which), mean, quantile(errors, 0.95), errors.back());
    EXPECT_LT(mean, options.ndt.cell) << to_string(which);
    if (which == Localizer::ndt_mcl_product) {
      EXPECT_LT(errors.back(), 1.0);
    }
  }
}

}  // namespace
}  // namespace alignability
