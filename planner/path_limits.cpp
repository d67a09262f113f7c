// SPDX-License-Identifier: BSD-3-Clause
#include "planner/path_limits.hpp"

#include <algorithm>

namespace alignability {
namespace {

// `advance(limit, state)`: the state after a way by that limit, nullopt where it is broken.
template <typename Advance>
std::optional<PathLimits::State> advanced(const PathLimits& limits, PathLimits::State state, Advance advance) {
  if (limits.error) {
    const auto error = advance(*limits.error, state.error);
    if (!error) return std::nullopt;
    state.error = *error;
  }
  if (limits.blind) {
    const auto blind = advance(*limits.blind, state.blind);
    if (!blind) return std::nullopt;
    state.blind = *blind;
  }
  return state;
}

const ErrorLimit::Change& part(const PathLimits::Change& change, const ErrorLimit&) { return change.error; }
const BlindLimit::Change& part(const PathLimits::Change& change, const BlindLimit&) { return change.blind; }

double share(double used, double most) { return used / std::max(most, BlindLimit::kRounding); }

}  // namespace

PathLimits::State PathLimits::at_start() const {
  State state;
  if (error) state.error = error->at_start();
  if (blind) state.blind = blind->at_start();
  return state;
}

PathLimits::Change PathLimits::change(const Eigen::Vector2d& from, const Eigen::Vector2d& to, const RiskField& risk) const {
  Change change{};
  if (error) change.error = error->change(from, to, risk);
  if (blind) change.blind = blind->change(from, to, risk);
  return change;
}

std::optional<PathLimits::State> PathLimits::after(const State& state, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                                                   const RiskField& risk) const {
  return advanced(*this, state, [&](const auto& limit, const auto& before) { return limit.after(before, from, to, risk); });
}

std::optional<PathLimits::State> PathLimits::after(const State& state, const Arc& arc, const RiskField& risk) const {
  return advanced(*this, state, [&](const auto& limit, const auto& before) { return limit.after(before, arc, risk); });
}

std::optional<PathLimits::State> PathLimits::after(const State& state, const Curve& curve, const RiskField& risk) const {
  std::optional<State> end = state;
  for (const Arc& arc : curve.arcs()) {
    if (end) end = after(*end, arc, risk);
  }
  return end;
}

std::optional<PathLimits::State> PathLimits::after(const State& state, const Change& change, const Eigen::Vector2d& from,
                                                   const Eigen::Vector2d& to, const RiskField& risk) const {
  return advanced(*this, state,
                  [&](const auto& limit, const auto& before) { return limit.after(before, part(change, limit), from, to, risk); });
}

bool PathLimits::is_no_worse(const State& one, const State& other, double alike) const {
  return (!error || error->is_no_worse(one.error, other.error, alike)) && (!blind || blind->is_no_worse(one.blind, other.blind, alike));
}

double PathLimits::urgency(const State& state) const {
  return (error ? share(state.error, error->most) : 0.0) + (blind ? share(state.blind.blind, blind->most) : 0.0);
}

}  // namespace alignability
