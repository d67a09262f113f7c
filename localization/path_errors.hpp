// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/bootstrap.hpp"
#include "costmap/clearance_map.hpp"
#include "localization/drive.hpp"

namespace alignability {

/// A run whose error exceeds this [m] is lost.
inline constexpr double kLostError = 0.5;

/// How far a localizer was off over several runs of a path [m], each with the interval that its runs leave open.
struct PathErrors {
  Interval mean;    ///< over all scans of all runs
  Interval p95;     ///< 95th percentile of the same
  Interval max;     ///< the greatest error of any run
  Interval goal;    ///< at the path's end, in the mean over the runs
  Interval lost;    ///< share of the runs that were lost at some place
  Interval unsafe;  ///< share of the scans where the error exceeds what the robot has to the nearest obstacle
};

/// Of one localizer, given by number, over runs of some paths, as many of each, by a disk of `radius` [m]. Runs of one number have the same
/// errors of odometry, so that they are drawn together. All scans count, the first metres too, where a localizer finds its place.
PathErrors path_errors(std::span<const std::vector<Drive>> paths, std::size_t localizer, const ClearanceMap& clearance, double radius,
                       const BootstrapOptions& options);

/// Errors over all runs at one place of a path.
struct ErrorAlong {
  double s = 0.0;  ///< arc length [m]
  double mean = 0.0;
  double p95 = 0.0;
};

/// Errors by arc length, in steps of `step` [m] > 0: that at s is over the scans within half a step. A step without scans is left out.
std::vector<ErrorAlong> errors_along(std::span<const Drive> runs, std::size_t localizer, double step);

}  // namespace alignability
