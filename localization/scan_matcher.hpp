// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "core/pose.hpp"
#include "localization/motion_noise.hpp"
#include "localization/plane_map.hpp"

namespace alignability {

struct ScanMatcherOptions {
  MotionNoise noise = {};
  double least_height = 0.2;  ///< points lower than this above `base_link` [m] are skipped: the floor tells x, y and yaw nothing
  double thinning = 0.2;      ///< side of the cubes of which each gives one point of a scan [m]
  double deviation = 0.02;    ///< of a point from its surface in the map [m]: a lidar's ±2 cm
  /// What share of its points a scan counts for, in (0, 1]. Points of one patch of the map, as large as the neighbourhood that gives it its
  /// normal (0.4 m), share the errors of that normal and of the map: some 3 at this thinning. They share them again with the next scans,
  /// until the robot has gone as far as the patch is wide: some 4 at 1 m/s and 10 Hz. 3 · 4 count as one.
  double independent_share = 1.0 / 12.0;
  /// The residual at which a point counts half, in such deviations (Cauchy's weight; 2.4 costs 5 % of the information where nothing is
  /// amiss).
  double outlier = 2.4;
  int iterations = 10;  ///< at most, of matching points anew from where the last led
};

/// Point-to-plane scan matching on a map (Chen and Medioni 1992), fused with odometry by an iterated extended Kalman filter, whose update
/// is a Gauss-Newton method from the predicted pose (Bell and Cathey 1993; with a lidar's points: Xu and Zhang, FAST-LIO, 2021). Points off
/// the map weigh less (Cauchy). One Gaussian: where two places look alike it follows the nearer. Draws no random numbers. Not for several
/// threads.
class ScanMatcher {
 public:
  /// Throws std::invalid_argument for options out of range, deviations below 0 and what is not finite.
  ScanMatcher(std::shared_ptr<const PlaneMap> map, const Pose2& start, const Pose2& deviations, const ScanMatcherOptions& options);

  /// Takes the motion that odometry reports, from the last pose's frame.
  void move(const Pose2& motion);
  /// Takes what the lidar sees, its points in the frame of `base_link`; those that are not finite are dropped. A scan that meets nothing of
  /// the map changes nothing. O(points · log points).
  void see(std::span<const Eigen::Vector3f> points);

  Pose2 estimate() const { return pose_; }
  /// Of x, y [m] and yaw [rad] in `map`.
  Eigen::Matrix3d covariance() const { return covariance_; }

 private:
  std::shared_ptr<const PlaneMap> map_;
  ScanMatcherOptions options_;
  Pose2 pose_;
  Eigen::Matrix3d covariance_;
};

}  // namespace alignability
