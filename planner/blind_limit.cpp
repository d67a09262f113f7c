// SPDX-License-Identifier: BSD-3-Clause
#include "planner/blind_limit.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <vector>

namespace alignability {
namespace {

Ground ground_at(double alpha, const RiskField& risk) {
  if (risk.is_blind(alpha)) return Ground::blind;
  return alpha >= risk.options().alpha_safe ? Ground::safe : Ground::poor;
}

// Of a Quadratic or a Cubic along a piece of a way.
template <typename Polynomial, typename Visit>
void walk_piece(double length, const Polynomial& alpha, const RiskField& risk, Visit& visit) {
  if (!alpha.is_number()) return visit(ground_at(std::numeric_limits<double>::quiet_NaN(), risk), length);
  const auto blind = alpha.crossings(risk.options().alpha_critical);
  const auto safe = alpha.crossings(risk.options().alpha_safe);
  std::array<double, 2 + 2 * std::tuple_size_v<decltype(blind)>> cuts{0.0, 1.0};
  std::ranges::copy(safe, std::ranges::copy(blind, cuts.begin() + 2).out);
  std::ranges::sort(cuts);
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    if (cuts[i + 1] > cuts[i]) visit(ground_at(alpha.at(0.5 * (cuts[i] + cuts[i + 1])), risk), length * (cuts[i + 1] - cuts[i]));
  }
}

// Calls `visit(ground, metres)` for each stretch of a straight way, in order.
template <typename Visit>
void walk(const Eigen::Vector2d& from, const Eigen::Vector2d& to, const RiskField& risk, Visit visit) {
  const double length = (to - from).norm();
  risk.alpha_layer().visit(from, to, [&](double share, const Quadratic& alpha) { walk_piece(share * length, alpha, risk, visit); });
}

// The same for a way on which it turns evenly.
template <typename Visit>
void walk(const Pose2& from, const Pose2& to, const RiskField& risk, Visit visit) {
  if (!risk.has_headings()) return walk(from.position(), to.position(), risk, visit);
  const double length = (to.position() - from.position()).norm();
  risk.alpha_headings().visit(from, to, [&](double share, const Cubic& alpha) { walk_piece(share * length, alpha, risk, visit); });
}

// The same for the stretches of an arc.
template <typename Visit>
void walk(const Arc& arc, const RiskField& risk, Visit visit) {
  const auto walk_piece = [&](const auto& alpha) {
    if (!alpha.is_number()) return visit(ground_at(std::numeric_limits<double>::quiet_NaN(), risk), alpha.length);
    std::vector<double> cuts{0.0};
    for (const double level : {risk.options().alpha_critical, risk.options().alpha_safe}) {
      double end = 0.0;
      alpha.visit_stretches(level, [&](double length, bool) { cuts.push_back(end += length); });
    }
    std::ranges::sort(cuts);
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      const double middle = 0.5 * (cuts[i] + cuts[i + 1] - alpha.length);
      if (cuts[i + 1] > cuts[i]) visit(ground_at(alpha.at(middle), risk), cuts[i + 1] - cuts[i]);
    }
  };
  risk.has_headings() ? risk.alpha_headings().visit(arc, walk_piece) : risk.alpha_layer().visit(arc, walk_piece);
}

BlindState moved(BlindState state, Ground ground, double metres, double recovery) {
  if (ground == Ground::blind) return {state.blind + metres, 0.0};
  if (ground == Ground::poor) return {state.blind, 0.0};
  state.safe += metres;
  if (state.safe >= recovery) state.blind = 0.0;
  return state;
}

// After a straight way, from and to, or an arc.
template <typename... Way>
std::optional<BlindState> after_way(const BlindLimit& limit, BlindState state, const RiskField& risk, const Way&... way) {
  bool kept = true;
  walk(way..., risk, [&](Ground ground, double metres) {
    state = moved(state, ground, metres, limit.recovery);
    kept = kept && state.blind <= limit.most + BlindLimit::kRounding;
  });
  return kept ? std::optional(state) : std::nullopt;
}

struct LongestUnrecovered {
  double recovery;
  double most = 0.0;
  BlindState state = {};

  void operator()(Ground ground, double metres) {
    state = moved(state, ground, metres, recovery);
    most = std::max(most, state.blind);
  }
};

}  // namespace

std::optional<BlindState> BlindLimit::after(State state, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                                            const RiskField& risk) const {
  return after_way(*this, state, risk, from, to);
}

std::optional<BlindState> BlindLimit::after(State state, const Arc& arc, const RiskField& risk) const {
  return after_way(*this, state, risk, arc);
}

BlindLimit::Change BlindLimit::change(const Eigen::Vector2d& from, const Eigen::Vector2d& to, const RiskField& risk) const {
  Change change{std::nullopt, (to - from).norm()};
  bool is_first = true;
  walk(from, to, risk, [&](Ground ground, double) {
    if (is_first || change.all == ground) {
      change.all = ground;
    } else {
      change.all.reset();
    }
    is_first = false;
  });
  return change;
}

std::optional<BlindState> BlindLimit::after(const State& state, const Change& change, const Eigen::Vector2d& from,
                                            const Eigen::Vector2d& to, const RiskField& risk) const {
  if (!change.all) return after(state, from, to, risk);
  const State then = moved(state, *change.all, change.length, recovery);
  return then.blind <= most + kRounding ? std::optional(then) : std::nullopt;
}

double longest_unrecovered(std::span<const Pose2> path, const RiskField& risk, double recovery) {
  LongestUnrecovered longest{recovery};
  for (std::size_t i = 1; i < path.size(); ++i) walk(path[i - 1], path[i], risk, std::ref(longest));
  return longest.most;
}

double longest_unrecovered(std::span<const Curve> path, const RiskField& risk, double recovery) {
  LongestUnrecovered longest{recovery};
  for (const Curve& curve : path) {
    for (const Arc& arc : curve.arcs()) walk(arc, risk, std::ref(longest));
  }
  return longest.most;
}

}  // namespace alignability
