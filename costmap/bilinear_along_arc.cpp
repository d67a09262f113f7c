// SPDX-License-Identifier: BSD-3-Clause
#include "costmap/bilinear_along_arc.hpp"

#include <algorithm>
#include <cmath>

namespace alignability {
namespace {

double sinc(double x) { return x == 0.0 ? 1.0 : std::sin(x) / x; }

constexpr double kSeries = 0.1;  // [rad] below which closed forms cancel and their series do not

// (1 - sinc h) / h.
double mean_sagitta(double h) {
  const double q = h * h;
  if (std::abs(h) < kSeries) return h / 6.0 * (1.0 - q / 20.0 * (1.0 - q / 42.0 * (1.0 - q / 72.0)));
  return (1.0 - sinc(h)) / h;
}

// (2 sinc h - 1 - sinc 2h) / h².
double mean_twist(double h) {
  const double q = h * h;
  if (std::abs(h) < kSeries) return 1.0 / 3.0 - q * (7.0 / 60.0 - q * (31.0 / 2520.0 - q * 127.0 / 181440.0));
  return (2.0 * sinc(h) - 1.0 - sinc(2.0 * h)) / q;
}

}  // namespace

// Along the direction by sin(κs)/κ, to its left by (1 - cos κs)/κ.
Eigen::Vector2d BilinearAlongArc::way(double s) const {
  const double half_turn = 0.5 * curvature * s;
  const double chord = s * sinc(half_turn);
  const Eigen::Vector2d left(-direction.y(), direction.x());
  return chord * (std::cos(half_turn) * direction + std::sin(half_turn) * left);
}

bool BilinearAlongArc::is_number() const { return !std::isnan(value) && !std::isnan(twist) && !gradient.hasNaN(); }

double BilinearAlongArc::at(double s) const {
  const Eigen::Vector2d p = way(s);
  return value + gradient.dot(p) + twist * p.x() * p.y();
}

double BilinearAlongArc::slope(double s) const {
  const Eigen::Vector2d p = way(s);
  const Eigen::Vector2d left(-direction.y(), direction.x());
  const Eigen::Vector2d heading = std::cos(curvature * s) * direction + std::sin(curvature * s) * left;
  return heading.dot(gradient + twist * Eigen::Vector2d(p.y(), p.x()));
}

// At least |d²/ds²| anywhere on the arc.
double BilinearAlongArc::steepest_bend() const {
  return std::abs(twist) + std::abs(curvature) * (gradient.norm() + std::abs(twist) * 0.5 * length);
}

double BilinearAlongArc::mean() const {
  const double half = 0.5 * length;
  const double h = curvature * half;
  const Eigen::Vector2d left(-direction.y(), direction.x());
  // What is odd about the middle has no mean.
  return value + half * mean_sagitta(h) * gradient.dot(left) + twist * half * half * mean_twist(h) * direction.x() * direction.y();
}

double BilinearAlongArc::crossing(double level, double from, double to) const {
  const bool is_below = at(from) < level;
  while (to - from > 1e-13 * length) {
    const double middle = 0.5 * (from + to);
    if (middle <= from || middle >= to) break;
    (at(middle) < level) == is_below ? from = middle : to = middle;
  }
  return 0.5 * (from + to);
}

double BilinearAlongArc::least() const {
  const double ends = std::min(at(-0.5 * length), at(0.5 * length));
  return least_within(-0.5 * length, 0.5 * length, ends);
}

double BilinearAlongArc::least_within(double from, double to, double so_far) const {
  constexpr double kWorthLooking = 1e-12;
  const double half = 0.5 * (to - from);
  const double middle = 0.5 * (from + to);
  const double here = at(middle);
  so_far = std::min(so_far, here);
  const double reach = half * (std::abs(slope(middle)) + 0.5 * half * steepest_bend());
  if (here - reach >= so_far - kWorthLooking) return so_far;
  so_far = least_within(from, middle, so_far);
  return least_within(middle, to, so_far);
}

}  // namespace alignability
