// SPDX-License-Identifier: BSD-3-Clause
#include "planner/path_figures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace alignability {
namespace {

class FigureSum {
 public:
  explicit FigureSum(const RiskField& risk) : risk_(risk) { figures_.risk_by_source.resize(risk.layers().size(), 0.0); }

  void add_segment(const Pose2& from, const Pose2& to) {
    const double length = (to.position() - from.position()).norm();
    figures_.length += length;
    figures_.turned += std::abs(normalized_angle(to.yaw - from.yaw));
    add_risk([&](const RiskLayer& layer) { return layer.integral(from, to); });
    const auto add = [&](double share, const auto& alpha) { add_piece(share * length, alpha); };
    if (risk_.has_headings()) {
      risk_.alpha_headings().visit(from, to, add);
    } else {
      risk_.alpha_layer().visit(from.position(), to.position(), add);
    }
  }

  void add_arc(const Arc& arc) {
    figures_.length += arc.length();
    figures_.turned += std::abs(arc.turn());
    if (arc.travel < 0.0) figures_.backward_length += arc.length();
    add_risk([&](const RiskLayer& layer) { return layer.integral(arc); });
    const auto add = [&](const auto& alpha) { add_piece(alpha); };
    risk_.has_headings() ? risk_.alpha_headings().visit(arc, add) : risk_.alpha_layer().visit(arc, add);
  }

  PathFigures result() const {
    PathFigures figures = figures_;
    for (std::size_t i = 0; i < risk_.layers().size(); ++i) {
      figures.risk_integral += risk_.layers()[i].weight * figures.risk_by_source[i];
    }
    figures.alpha_mean = figures.evaluated_length > 0.0 ? alpha_integral_ / figures.evaluated_length : alpha_min_;
    figures.alpha_min = alpha_min_;
    return figures;
  }

 private:
  template <typename Integral>
  void add_risk(Integral integral) {
    for (std::size_t i = 0; i < risk_.layers().size(); ++i) figures_.risk_by_source[i] += integral(risk_.layers()[i]);
  }

  // A Quadratic, or a Cubic where it depends on heading.
  template <typename Polynomial>
  void add_piece(double length, const Polynomial& alpha) {
    if (!alpha.is_number()) {
      add_stretch(length, risk_.is_blind(std::numeric_limits<double>::quiet_NaN()));
      return;
    }
    figures_.evaluated_length += length;
    alpha_integral_ += length * alpha.mean();
    alpha_min_ = std::fmin(alpha_min_, alpha.least());
    double done = 0.0;
    const auto add_until = [&](double cut) {
      if (cut > done) add_stretch(length * (cut - done), risk_.is_blind(alpha.at(0.5 * (done + cut))));
      done = cut;
    };
    for (const double cut : alpha.crossings(risk_.options().alpha_critical)) add_until(cut);
    add_until(1.0);
  }

  template <typename AlongArc>
  void add_piece(const AlongArc& alpha) {
    if (!alpha.is_number()) {
      add_stretch(alpha.length, risk_.is_blind(std::numeric_limits<double>::quiet_NaN()));
      return;
    }
    figures_.evaluated_length += alpha.length;
    alpha_integral_ += alpha.length * alpha.mean();
    alpha_min_ = std::fmin(alpha_min_, alpha.least());
    alpha.visit_stretches(risk_.options().alpha_critical, [&](double length, bool is_below) { add_stretch(length, is_below); });
  }

  void add_stretch(double length, bool blind) {
    current_blind_ = blind ? current_blind_ + length : 0.0;
    if (blind) figures_.blind_length += length;
    figures_.longest_blind = std::max(figures_.longest_blind, current_blind_);
  }

  const RiskField& risk_;
  PathFigures figures_;
  double current_blind_ = 0.0;
  double alpha_integral_ = 0.0;
  double alpha_min_ = std::numeric_limits<double>::quiet_NaN();
};

}  // namespace

PathFigures measure(std::span<const Pose2> path, const RiskField& risk) {
  FigureSum sum(risk);
  if (path.size() == 1) sum.add_segment(path[0], path[0]);
  for (std::size_t i = 0; i + 1 < path.size(); ++i) sum.add_segment(path[i], path[i + 1]);
  return sum.result();
}

PathFigures measure(std::span<const Curve> path, const RiskField& risk) {
  FigureSum sum(risk);
  // What stands still has an α all the same.
  if (!path.empty()) sum.add_segment(path.front().start(), path.front().start());
  for (const Curve& curve : path) {
    for (const Arc& arc : curve.arcs()) sum.add_arc(arc);
  }
  return sum.result();
}

std::vector<PathSample> sample(std::span<const Pose2> path, const RiskField& risk, double step) {
  std::vector<PathSample> samples;
  double s = 0.0;
  const auto add = [&](const Pose2& pose, double at) {
    samples.push_back({pose, at, risk.alpha(pose.x, pose.y, pose.yaw), risk.risk(pose.x, pose.y, pose.yaw)});
  };
  for (std::size_t i = 0; i < path.size(); ++i) {
    add(path[i], s);
    if (i + 1 == path.size()) break;
    const Pose2& from = path[i];
    const Pose2& to = path[i + 1];
    const double length = (to.position() - from.position()).norm();
    const double turn = normalized_angle(to.yaw - from.yaw);
    const auto pieces = static_cast<std::size_t>(std::max(1.0, std::ceil(length / step)));
    for (std::size_t k = 1; k < pieces; ++k) {
      const double share = static_cast<double>(k) / static_cast<double>(pieces);
      add({from.x + share * (to.x - from.x), from.y + share * (to.y - from.y), normalized_angle(from.yaw + share * turn)},
          s + share * length);
    }
    s += length;
  }
  return samples;
}

}  // namespace alignability
