// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/pose.hpp"

namespace alignability {

/// How far a motion may lead elsewhere than odometry has it: standard deviations along x and y of `base_link` [m] and of yaw [rad], in
/// proportion to the metres driven and, on top, to the radians turned.
struct MotionNoise {
  Pose2 per_metre{0.05, 0.05, 0.01};
  Pose2 per_radian{0.1, 0.01, 0.1};
};

/// The standard deviations of one motion, in its frame. Of n equal motions in its stead they are 1/n each, and their sum's 1/√n.
Pose2 deviations_of(const Pose2& motion, const MotionNoise& noise);

/// The pose reached from `pose` by a motion in its frame.
Pose2 moved(const Pose2& pose, const Pose2& motion);

}  // namespace alignability
