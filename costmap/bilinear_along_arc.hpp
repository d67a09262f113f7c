// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "costmap/extremes_along.hpp"

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
  /// d/ds.
  double slope(double s) const;
  /// At least |d/ds|, and |d²/ds²|, anywhere on the arc.
  double steepest_slope() const;
  double steepest_bend() const;
  /// In closed form, to some 1e-13.
  double mean() const;
  /// The mean of s times it, likewise, to some 1e-12 of what it may be [m].
  double mean_moment() const;
  /// To 1e-11.
  double least() const { return detail::least_along(*this); }

  /// Calls `visit(length, is_below)` for the stretches on either side of a level, in order. They add up to the length; their ends are
  /// found to 1e-12 of it.
  template <typename Visitor>
  void visit_stretches(double level, Visitor&& visit) const {
    detail::visit_stretches(*this, level, visit);
  }

 private:
  Eigen::Vector2d way(double s) const;
};

}  // namespace alignability
