// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <numbers>

namespace alignability {

/// A pose of `base_link` in `map`: metres and radians, yaw counter-clockwise from +x (REP-103).
struct Pose2 {
  double x = 0.0;
  double y = 0.0;
  double yaw = 0.0;

  Eigen::Vector2d position() const { return {x, y}; }
  bool operator==(const Pose2&) const = default;
};

/// The same angle in [-π, π].
inline double normalized_angle(double angle) { return std::remainder(angle, 2.0 * std::numbers::pi); }

/// The pose at a share in [0,1] of the straight way between two, turning evenly the shorter way around.
inline Pose2 between(const Pose2& from, const Pose2& to, double share) {
  return {from.x + share * (to.x - from.x), from.y + share * (to.y - from.y), from.yaw + share * normalized_angle(to.yaw - from.yaw)};
}

inline constexpr double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }
inline constexpr double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

}  // namespace alignability
