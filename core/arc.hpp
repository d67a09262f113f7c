// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/pose.hpp"

namespace alignability {

/// A motion of `base_link` on a circle or straight on, forward or backward, its heading along the way.
struct Arc {
  Arc() = default;
  // No aggregate: three numbers make a pose, and no arc.
  Arc(const Pose2& from, double its_curvature, double its_travel) : start(from), curvature(its_curvature), travel(its_travel) {}

  Pose2 start;
  double curvature = 0.0;  ///< of the circle, to the left positive [1/m]; 0 is straight
  double travel = 0.0;     ///< [m]; backward negative

  double length() const { return std::abs(travel); }
  /// By how much the yaw grows [rad].
  double turn() const { return curvature * travel; }
  /// After `s` in [0, length()] metres; the yaw goes on without a jump.
  Pose2 at(double s) const {
    const double half_turn = 0.5 * curvature * std::copysign(s, travel);
    const double chord = std::copysign(s, travel) * (half_turn == 0.0 ? 1.0 : std::sin(half_turn) / half_turn);
    const double along = start.yaw + half_turn;
    return {start.x + chord * std::cos(along), start.y + chord * std::sin(along), along + half_turn};
  }
  Pose2 end() const { return at(length()); }
  /// From one arc length to a later one.
  Arc piece(double from, double to) const { return {at(from), curvature, std::copysign(to - from, travel)}; }
  /// How far it leaves its chord [m]; of an arc that turns by at most π.
  double bulge() const {
    const double quarter = std::sin(0.25 * turn());
    return curvature == 0.0 ? 0.0 : 2.0 * quarter * quarter / std::abs(curvature);
  }
};

}  // namespace alignability
