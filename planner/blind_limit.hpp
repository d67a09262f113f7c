// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <optional>
#include <span>

#include "core/pose.hpp"
#include "costmap/risk_field.hpp"
#include "planner/curve.hpp"

namespace alignability {

enum class Ground {
  blind,  ///< RiskField::is_blind
  poor,   ///< neither
  safe,   ///< α of at least alpha_safe
};

/// How blind a robot came to a place.
struct BlindState {
  double blind = 0.0;                                     ///< blind metres since it last found itself
  double safe = std::numeric_limits<double>::infinity();  ///< safe metres without a break, up to here
};

/// At most so many metres may be blind between one place where a robot finds itself and the next: it does at the start, and after
/// `recovery` safe metres without a break. Poor ground counts for neither. Exact: no sampling. Safe to read from many threads.
struct BlindLimit {
  static constexpr double kRounding = 1e-9;  ///< [m] by which sums over a path may exceed it

  using State = BlindState;
  /// Of ground that is all of one kind: which. Else it is looked at again.
  struct Change {
    std::optional<Ground> all;
    double length = 0.0;  ///< [m]
  };

  double most = 0.0;      ///< [m], >= 0
  double recovery = 1.0;  ///< [m], > 0

  State at_start() const { return {}; }
  /// Of straight ways only by a risk field that takes no notice of headings.
  Change change(const Eigen::Vector2d& from, const Eigen::Vector2d& to, const RiskField& risk) const;

  /// How blind a robot gets along a straight way; nullopt where it breaks the limit on it. O(α-cells crossed).
  std::optional<State> after(State state, const Eigen::Vector2d& from, const Eigen::Vector2d& to, const RiskField& risk) const;
  std::optional<State> after(const State& state, const Change& change, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                             const RiskField& risk) const;
  /// Along an arc.
  std::optional<State> after(State state, const Arc& arc, const RiskField& risk) const;
  bool is_no_worse(const State& one, const State& other, double alike) const {
    return one.blind <= other.blind + alike * most && (one.blind == 0.0 || one.safe >= other.safe - alike * recovery);
  }
};

/// The most blind metres without finding itself that a path brings a robot.
double longest_unrecovered(std::span<const Pose2> path, const RiskField& risk, double recovery);
double longest_unrecovered(std::span<const Curve> path, const RiskField& risk, double recovery);

}  // namespace alignability
