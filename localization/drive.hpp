// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "lidar/scene.hpp"
#include "lidar/sensor_rig.hpp"
#include "localization/localizer.hpp"
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

/// What a robot is and does on any path.
struct DriveOptions {
  Pace pace = {};
  OdometryError odometry = {};                                   ///< the truth, of which localizers know nothing
  std::vector<Localizer> localizers = {Localizer::ndt_mcl_sum};  ///< all see the same drive
  LocalizerOptions localizer = {};
  std::optional<double> range_max = {};  ///< [m] crops the sensor's own range
  double floor = 0.0;                    ///< z of `base_link` in `map` [m]
};

struct DriveSample {
  TimedPose truth;
  std::vector<Pose2> estimates;  ///< one a localizer, in their order

  double error(std::size_t localizer) const { return (estimates[localizer].position() - truth.pose.position()).norm(); }  ///< [m]
};

/// A sample each turn of the lidar, and one at the end.
using Drive = std::vector<DriveSample>;

/// Drives the true path, whatever localizers believe, with a scan each turn of the lidar, taken in an instant. Localizers start from a pose
/// that is as far off as they expect, on a map made with `for_sensor(options.localizer, sensor)`. The seed stands for all errors, of
/// odometry, ranges and start: the same one gives the same errors on every path. Throws Interrupted, and std::invalid_argument for options
/// out of range.
Drive drive(const Scene& scene, const SensorRig& sensor, const LocalizationMap& map, std::span<const Pose2> path,
            const DriveOptions& options, std::uint64_t seed, std::stop_token stop);

}  // namespace alignability
