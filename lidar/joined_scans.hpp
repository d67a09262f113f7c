// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/progress.hpp"
#include "lidar/scan_log.hpp"

namespace alignability {

struct JoinOptions {
  double range_min = 0.5;                ///< [m] nearer returns are dropped: the robot itself, and fillers at the sensor
  std::optional<double> range_max = {};  ///< [m] farther ones too
  std::optional<double> thinning = {};   ///< [m] leaves about one point in each cube of this side, near the mean of those that were there
  ProgressCallback progress = {};
  std::stop_token stop = {};
};

/// What the scans of a log saw, as one cloud in `map`, scan after scan, or by cube where it is thinned. Throws InputError for a scan that
/// cannot be read or was taken more than 65 km from the origin, and where more than 2^26 points would remain, std::invalid_argument for a
/// thinning that is not greater than 0, Interrupted.
std::vector<Eigen::Vector3f> joined(std::span<const PosedScan> scans, const JoinOptions& options);

}  // namespace alignability
