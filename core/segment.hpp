// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>

namespace alignability {

/// From a point to the nearest one of a segment, which may have no length.
inline double distance_to_segment(const Eigen::Vector2d& point, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  const Eigen::Vector2d step = to - from;
  const double squared = step.squaredNorm();
  const double share = squared > 0.0 ? std::clamp((point - from).dot(step) / squared, 0.0, 1.0) : 0.0;
  return (point - from - share * step).norm();
}

}  // namespace alignability
