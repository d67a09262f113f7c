// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "lidar/lidar_model.hpp"
#include "lidar/scene.hpp"
#include "localization/ndt_mcl.hpp"
#include "localization/odometry.hpp"

namespace alignability {

/// How a robot goes along a path of straight pieces, turning evenly along each.
struct Pace {
  double speed = 1.0;      ///< [m/s]
  double turn_rate = 0.8;  ///< at most [rad/s], on the spot too
};

struct TimedPose {
  double seconds = 0.0;
  double s = 0.0;  ///< arc length [m]
  Pose2 pose;
};

/// Where it is each `period` [s], and at the end. Throws std::invalid_argument for a pace or period that is not greater than 0. Empty for a
/// path without poses.
std::vector<TimedPose> poses_along(std::span<const Pose2> path, const Pace& pace, double period);

struct DriveOptions {
  Pace pace;
  OdometryError odometry = {};
  NdtOptions ndt = {};  ///< of the scans
  NdtMclOptions filter = {};
  Pose2 start_deviations{0.1, 0.1, radians(1)};  ///< what the filter knows of the start
  std::optional<double> range_max = {};          ///< [m] crops the sensor's own range
  double floor = 0.0;                            ///< z of `base_link` in `map` [m]
  std::uint64_t seed = 1;                        ///< of odometry, range noise and filter
  std::stop_token stop = {};
};

struct DriveSample {
  TimedPose truth;
  Pose2 estimate;

  double error() const { return (estimate.position() - truth.pose.position()).norm(); }  ///< [m]
};

/// Drives the true path, whatever the localizer believes, with a scan each turn of the lidar, taken in an instant, and localizes by NDT-MCL
/// on a map. The same seed gives the same errors on every path. Throws Interrupted.
std::vector<DriveSample> drive(const Scene& scene, const LidarModel& lidar, std::shared_ptr<const Ndt> map, std::span<const Pose2> path,
                               const DriveOptions& options);

}  // namespace alignability
