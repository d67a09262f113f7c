// SPDX-License-Identifier: BSD-3-Clause
#include "planner/pose_refinement.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "planner/shortcuts.hpp"

namespace alignability {
namespace {

using Poses = std::vector<Pose2>;

// The same way with poses added, so that none is further from the next than `spacing` [m]. Motions that touch an obstacle and whose pieces
// would, by rounding, not be allowed stay whole.
Poses subdivided(const Poses& path, double spacing, const PoseMotion& motion) {
  Poses finer{path.front()};
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double length = (path[i].position() - path[i - 1].position()).norm();
    const int pieces = std::max(1, static_cast<int>(std::ceil(length / spacing)));
    const std::size_t before = finer.size();
    bool allowed = true;
    for (int piece = 1; piece < pieces && allowed; ++piece) {
      finer.push_back(between(path[i - 1], path[i], static_cast<double>(piece) / pieces));
      allowed = motion.is_allowed(finer[finer.size() - 2], finer.back());
    }
    if (!allowed || !motion.is_allowed(finer.back(), path[i])) finer.resize(before);
    finer.push_back(path[i]);
  }
  return finer;
}

// Moves a pose by `step` [m], or turns it by as many radians, where that lowers the cost; whether it did.
bool move_pose(Poses& path, std::size_t i, const PoseMotion& motion, double step) {
  const Pose2 at = path[i];
  const double before = motion.cost(path[i - 1], at) + motion.cost(at, path[i + 1]);
  const std::array<Pose2, 6> moves{{{at.x + step, at.y, at.yaw},
                                    {at.x - step, at.y, at.yaw},
                                    {at.x, at.y + step, at.yaw},
                                    {at.x, at.y - step, at.yaw},
                                    {at.x, at.y, at.yaw + step},
                                    {at.x, at.y, at.yaw - step}}};
  for (const Pose2& to : moves) {
    const double cost = motion.cost(path[i - 1], to) + motion.cost(to, path[i + 1]);
    if (cost >= before - 1e-9 * before || !motion.is_allowed(path[i - 1], to) || !motion.is_allowed(to, path[i + 1])) continue;
    path[i] = to;
    return true;
  }
  return false;
}

// Each pose but the ends, by steps from `step` on down to a thousandth of it.
void relax(Poses& path, const PoseMotion& motion, double step, const StopTest& stop) {
  constexpr int kSweeps = 60;
  std::vector<double> steps(path.size(), step);  // of each, halved where none helps
  bool going_on = true;
  for (int sweep = 0; sweep < kSweeps && going_on; ++sweep) {
    going_on = false;
    for (std::size_t i = 1; i + 1 < path.size(); ++i) {
      if (steps[i] < 1e-3 * step) continue;
      if (is_told_to_stop(stop)) return;
      going_on = true;
      steps[i] *= move_pose(path, i, motion, steps[i]) ? 1.5 : 0.5;
    }
  }
}

}  // namespace

double PoseMotion::cost(const Pose2& from, const Pose2& to) const {
  const double turned = std::abs(normalized_angle(to.yaw - from.yaw));
  return (to.position() - from.position()).norm() + weight * area.risk_field()->integral(from, to) + turn_cost * turned;
}

Poses refined(Poses path, const PoseMotion& motion, const StopTest& stop) {
  path = with_shortcuts(path, motion);
  for (const double spacing : {2.0, 1.0, 0.5}) {
    if (is_told_to_stop(stop)) break;
    path = subdivided(path, spacing, motion);
    relax(path, motion, 0.25 * spacing, stop);
    path = with_shortcuts(path, motion);
  }
  return path;
}

}  // namespace alignability
