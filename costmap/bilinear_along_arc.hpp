// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace alignability {

/// A bilinear function of the plane along an arc, written about the arc's middle: value + gradient·p + twist·p.x·p.y, p the way from the
/// middle. Arc lengths s are counted from the middle, in [-length/2, length/2].
struct BilinearAlongArc {
  double length = 0.0;              ///< [m]
  double curvature = 0.0;           ///< in the direction of travel, to the left positive [1/m]; 0 is straight
  Eigen::Vector2d direction{1, 0};  ///< of travel, in the middle
  double value = 0.0;               ///< in the middle
  Eigen::Vector2d gradient{0, 0};   ///< [1/m]
  double twist = 0.0;               ///< [1/m²]

  /// False where a corner of the patch has no value.
  bool is_number() const;
  double at(double s) const;
  /// In closed form, to some 1e-13.
  double mean() const;
  /// To 1e-11.
  double least() const;

  /// Calls `visit(length, is_below)` for the stretches on either side of a level, in order. They add up to the length; their ends are
  /// found to 1e-12 of it.
  template <typename Visitor>
  void visit_stretches(double level, Visitor&& visit) const {
    visit_stretches(level, -0.5 * length, 0.5 * length, visit);
  }

 private:
  Eigen::Vector2d way(double s) const;
  double slope(double s) const;
  double steepest_bend() const;
  double crossing(double level, double from, double to) const;
  double least_within(double from, double to, double so_far) const;

  template <typename Visitor>
  void visit_stretches(double level, double from, double to, Visitor& visit) const {
    const double half = 0.5 * (to - from);
    const double middle = 0.5 * (from + to);
    const double over = at(middle) - level;
    const double steep = std::abs(slope(middle));
    const double bend = half * steepest_bend();
    if (std::abs(over) >= half * (steep + 0.5 * bend) || half <= 1e-12 * length) {
      visit(to - from, over < 0.0);
    } else if (steep >= bend) {
      visit_monotone(level, from, to, visit);
    } else {
      visit_stretches(level, from, middle, visit);
      visit_stretches(level, middle, to, visit);
    }
  }

  template <typename Visitor>
  void visit_monotone(double level, double from, double to, Visitor& visit) const {
    const bool is_below = at(from) < level;
    if (is_below == (at(to) < level)) return visit(to - from, is_below);
    const double met = crossing(level, from, to);
    visit(met - from, is_below);
    visit(to - met, !is_below);
  }
};

}  // namespace alignability
