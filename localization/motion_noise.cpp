// SPDX-License-Identifier: BSD-3-Clause
#include "localization/motion_noise.hpp"

#include <cmath>

namespace alignability {

Pose2 deviations_of(const Pose2& motion, const MotionNoise& noise) {
  const double metres = motion.position().norm();
  const double turned = std::abs(motion.yaw);
  const auto deviation = [&](double Pose2::*axis) { return noise.per_metre.*axis * metres + noise.per_radian.*axis * turned; };
  return {deviation(&Pose2::x), deviation(&Pose2::y), deviation(&Pose2::yaw)};
}

Pose2 moved(const Pose2& pose, const Pose2& motion) {
  const double c = std::cos(pose.yaw), s = std::sin(pose.yaw);
  return {pose.x + c * motion.x - s * motion.y, pose.y + s * motion.x + c * motion.y, normalized_angle(pose.yaw + motion.yaw)};
}

}  // namespace alignability
