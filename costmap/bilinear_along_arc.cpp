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

// (sin h - h cos h) / h³.
double moment_along(double h) {
  const double q = h * h;
  if (std::abs(h) < kSeries) return 1.0 / 3.0 - q * (1.0 / 30.0 - q * (1.0 / 840.0 - q / 45360.0));
  return (std::sin(h) - h * std::cos(h)) / (q * h);
}

// (moment_along(h) - moment_along(2h)) / h.
double moment_aside(double h) {
  const double q = h * h;
  if (std::abs(h) < kSeries) return h * (1.0 / 10.0 - q * (1.0 / 56.0 - q * (1.0 / 720.0 - q * 17.0 / 266112.0)));
  return (moment_along(h) - moment_along(2.0 * h)) / h;
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

double BilinearAlongArc::steepest_slope() const { return gradient.norm() + std::abs(twist) * 0.5 * length; }

double BilinearAlongArc::steepest_bend() const {
  // The twist bends what runs diagonally, and not at all what keeps to an axis.
  const double diagonal = std::min(1.0, 2.0 * std::abs(direction.x() * direction.y()) + std::abs(curvature) * length);
  return diagonal * std::abs(twist) + std::abs(curvature) * (gradient.norm() + std::abs(twist) * 0.5 * length);
}

double BilinearAlongArc::mean() const {
  const double half = 0.5 * length;
  const double h = curvature * half;
  const Eigen::Vector2d left(-direction.y(), direction.x());
  // What is odd about the middle has no mean.
  return value + half * mean_sagitta(h) * gradient.dot(left) + twist * half * half * mean_twist(h) * direction.x() * direction.y();
}

double BilinearAlongArc::mean_moment() const {
  const double half = 0.5 * length;
  const double h = curvature * half;
  // What is even about the middle has none. Of p.x·p.y the odd part is along·aside times this.
  const double turned = direction.x() * direction.x() - direction.y() * direction.y();
  return half * half * (moment_along(h) * gradient.dot(direction) + half * moment_aside(h) * twist * turned);
}

}  // namespace alignability
