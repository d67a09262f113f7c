// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "planner/blind_limit.hpp"
#include "planner/error_limit.hpp"

namespace alignability {

/// What may become of a robot on its way, and so depends on the whole of it: how far it may err, how long it may be blind, or both. Safe to
/// read from many threads.
struct PathLimits {
  struct State {
    double error = 0.0;  ///< [m]; 0 without a limit of it
    BlindState blind;
  };
  /// What a straight way makes of a state.
  struct Change {
    ErrorLimit::Change error;
    BlindLimit::Change blind;
  };

  std::optional<ErrorLimit> error = {};
  std::optional<BlindLimit> blind = {};

  bool empty() const { return !error && !blind; }
  State at_start() const;
  Change change(const Eigen::Vector2d& from, const Eigen::Vector2d& to, const RiskField& risk) const;

  /// The state after a straight way, an arc or a curve; nullopt where a limit is broken on it.
  std::optional<State> after(const State& state, const Eigen::Vector2d& from, const Eigen::Vector2d& to, const RiskField& risk) const;
  std::optional<State> after(const State& state, const Arc& arc, const RiskField& risk) const;
  std::optional<State> after(const State& state, const Curve& curve, const RiskField& risk) const;
  /// The same, sooner, of a straight way whose change is known.
  std::optional<State> after(const State& state, const Change& change, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                             const RiskField& risk) const;
  /// Whether one state is no worse than another but for such a share of what is allowed. If so, it stays so whatever way is taken.
  bool is_no_worse(const State& one, const State& other, double alike) const;
  /// The sum of the shares of what is allowed that are used up.
  double urgency(const State& state) const;
};

}  // namespace alignability
