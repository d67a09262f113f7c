// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>

#include "lidar/lidar_model.hpp"
#include "lidar/scan.hpp"
#include "lidar/scene.hpp"

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
};

/// What the lidar sees of the scene: one ring-major scan, as if taken in an instant. With a key, ranges carry Gaussian noise of
/// `model.range_stddev`, one draw a beam whether it hits or not, so that the noise does not depend on the scene; without, none. Measured
/// ranges outside [range_min, range_max] are NaN. Throws std::invalid_argument for a pose that is not finite.
Scan simulate_scan(const Scene& scene, const LidarModel& model, const Eigen::Isometry3d& T_map_lidar, const ScanOptions& options = {},
                   std::optional<NoiseKey> noise = std::nullopt);

}  // namespace alignability
