// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>

#include "lidar/lidar_model.hpp"
#include "lidar/scan.hpp"
#include "lidar/scene.hpp"
#include "lidar/sensor_rig.hpp"

namespace alignability {

struct ScanOptions {
  /// Drops returns beyond it [m], where the sensor itself sees farther.
  std::optional<double> range_max;
};

/// Names one draw of range noise. The same key gives the same noise whatever was drawn before and by whichever thread.
struct NoiseKey {
  std::uint64_t seed = 0;
  std::uint64_t cell = 0;
  std::uint64_t sample = 0;
  std::uint64_t lidar = 0;  ///< its place in the rig
};

/// What the lidar sees of the scene: one ring-major scan, as if taken in an instant. With a key, ranges carry Gaussian noise of
/// `model.range_stddev`, one draw a beam whether it hits or not, so that the noise does not depend on the scene; without, none. Measured
/// ranges outside [range_min, range_max] are NaN. Throws std::invalid_argument for a pose that is not finite,
/// and for a `range_max` within which the lidar sees nothing.
Scan simulate_scan(const Scene& scene, const LidarModel& model, const Eigen::Isometry3d& T_map_lidar, const ScanOptions& options = {},
                   std::optional<NoiseKey> noise = std::nullopt);

/// What the lidars of a robot see, each from its mount, as simulate_scan has it for one; `noise.lidar` counts them. Ranges, and their
/// limits, are from each lidar. Of one lidar the scan is in its own frame, of several they are joined in `base_link`.
Scan simulate_rig_scan(const Scene& scene, const SensorRig& rig, const Eigen::Isometry3d& T_map_base, const ScanOptions& options = {},
                       std::optional<NoiseKey> noise = std::nullopt);

/// A scan of all beams of a rig as simulate_rig_scan joins them, such as a file keeps, which forgets whose they are: tells them apart
/// again, and drops what is nearer to its lidar than that lidar's least range. Of a rig of one lidar it is the scan as it stands. Throws
/// std::invalid_argument that completes "the scan …" where it has another number of points than the rig has beams.
Scan told_apart(Scan scan, const SensorRig& rig);

}  // namespace alignability
