// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <random>

#include "core/pose.hpp"

namespace alignability {

/// What odometry reports wrongly: a share of the way too much or too little and a turn that is not there, always the same, and noise whose
/// variance grows with the way. Apart from what a filter assumes.
struct OdometryError {
  double scale_bias = 0.0;      ///< of the way driven: 0.01 reports 1 % too much
  double heading_bias = 0.0;    ///< turned too much in a metre driven [rad/m]
  double position_noise = 0.0;  ///< standard deviation along x and along y after a metre driven [m/√m], >= 0
  double heading_noise = 0.0;   ///< of yaw after a metre driven [rad/√m], >= 0
  double turning_noise = 0.0;   ///< of yaw after a radian turned [rad/√rad], >= 0
};

/// Reports motions with errors. The same seed makes the same errors for the same motions. Not for several threads.
class Odometry {
 public:
  /// Throws std::invalid_argument for values that are not finite and noise below 0.
  Odometry(const OdometryError& error, std::uint64_t seed);

  /// What is reported of a true motion, from the frame of the pose before to that after.
  Pose2 report(const Pose2& motion);

 private:
  OdometryError error_;
  std::mt19937_64 engine_;
};

}  // namespace alignability
