// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "core/pose.hpp"
#include "costmap/risk_field.hpp"

namespace alignability::test {

/// What longest_unrecovered tells, by steps of a millimetre, with nothing of the library's but α.
inline double walked_unrecovered(std::span<const Pose2> path, const RiskField& risk, double recovery) {
  double blind = 0.0, safe = std::numeric_limits<double>::infinity(), longest = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Eigen::Vector2d from = path[i - 1].position(), to = path[i].position();
    const int steps = std::max(1, static_cast<int>(std::ceil((to - from).norm() / 1e-3)));
    for (int k = 0; k < steps; ++k) {
      const Eigen::Vector2d at = from + (k + 0.5) / steps * (to - from);
      const double metres = (to - from).norm() / steps;
      const double alpha = risk.alpha(at.x(), at.y(), 0.0);
      const bool is_blind = std::isnan(alpha) ? risk.options().unknown != UnknownPolicy::neutral : alpha < risk.options().alpha_critical;
      safe = !std::isnan(alpha) && alpha >= risk.options().alpha_safe ? safe + metres : 0.0;
      if (is_blind) blind += metres;
      if (safe >= recovery) blind = 0.0;
      longest = std::max(longest, blind);
    }
  }
  return longest;
}

}  // namespace alignability::test
