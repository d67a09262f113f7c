// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "core/arc.hpp"

namespace alignability {

/// A motion of a car: up to five arcs, one after the other.
class Curve {
 public:
  static constexpr std::size_t kMostArcs = 5;

  /// One that stays where it is.
  explicit Curve(const Pose2& start) : start_(start) {}

  /// Goes on from the end (see Arc); what has no length is left out. At most kMostArcs times.
  void append(double curvature, double travel);

  std::span<const Arc> arcs() const { return {arcs_.data(), count_}; }
  const Pose2& start() const { return start_; }
  Pose2 end() const { return count_ == 0 ? start_ : arcs_[count_ - 1].end(); }
  /// After `s` in [0, length()] metres.
  Pose2 at(double s) const;
  /// What it is up to there.
  Curve until(double s) const;

  double length() const;           ///< [m]
  double backward_length() const;  ///< of it driven backward [m]
  double turned() const;           ///< ∫ |dyaw| [rad]

 private:
  Pose2 start_;
  std::array<Arc, kMostArcs> arcs_{};
  std::size_t count_ = 0;
};

/// How far a curve may be from the chord between two poses of a path [m].
inline constexpr double kLargestSagitta = 1e-3;

/// Poses along curves that go on from one another, their ends among them: so many that nothing on an arc is further than `sagitta` [m] from
/// the chord between two. Yaws in [-π, π].
std::vector<Pose2> poses_along(std::span<const Curve> curves, double sagitta);
/// The same, and denser where a chord is not drivable straight on, turning evenly: down to a thousandth of the sagitta.
std::vector<Pose2> poses_along(std::span<const Curve> curves, double sagitta,
                               const std::function<bool(const Pose2& from, const Pose2& to)>& is_drivable);

}  // namespace alignability
