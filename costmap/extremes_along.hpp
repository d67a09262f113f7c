// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

namespace alignability::detail {

// What follows is of functions of arc length, `f.at(s)` for s in [-f.length/2, f.length/2], with `f.slope(s)` and `f.steepest_bend()`,
// which is at least |f''| anywhere.

template <typename Function>
double least_along(const Function& f, double from, double to, double so_far) {
  constexpr double kWorthLooking = 1e-12;
  const double half = 0.5 * (to - from);
  const double middle = 0.5 * (from + to);
  const double here = f.at(middle);
  so_far = std::min(so_far, here);
  const double reach = half * (std::abs(f.slope(middle)) + 0.5 * half * f.steepest_bend());
  if (here - reach >= so_far - kWorthLooking) return so_far;
  so_far = least_along(f, from, middle, so_far);
  return least_along(f, middle, to, so_far);
}

/// Its least value, to 1e-11.
template <typename Function>
double least_along(const Function& f) {
  const double ends = std::min(f.at(-0.5 * f.length), f.at(0.5 * f.length));
  return least_along(f, -0.5 * f.length, 0.5 * f.length, ends);
}

template <typename Function>
double crossing_along(const Function& f, double level, double from, double to) {
  const bool is_below = f.at(from) < level;
  while (to - from > 1e-13 * f.length) {
    const double middle = 0.5 * (from + to);
    if (middle <= from || middle >= to) break;
    (f.at(middle) < level) == is_below ? from = middle : to = middle;
  }
  return 0.5 * (from + to);
}

template <typename Function, typename Visitor>
void visit_monotone(const Function& f, double level, double from, double to, Visitor& visit) {
  const bool is_below = f.at(from) < level;
  if (is_below == (f.at(to) < level)) return visit(to - from, is_below);
  const double met = crossing_along(f, level, from, to);
  visit(met - from, is_below);
  visit(to - met, !is_below);
}

template <typename Function, typename Visitor>
void visit_stretches(const Function& f, double level, double from, double to, Visitor& visit) {
  const double half = 0.5 * (to - from);
  const double middle = 0.5 * (from + to);
  const double over = f.at(middle) - level;
  const double steep = std::abs(f.slope(middle));
  const double bend = half * f.steepest_bend();
  if (std::abs(over) >= half * (steep + 0.5 * bend) || half <= 1e-12 * f.length) {
    visit(to - from, over < 0.0);
  } else if (steep >= bend) {
    visit_monotone(f, level, from, to, visit);
  } else {
    visit_stretches(f, level, from, middle, visit);
    visit_stretches(f, level, middle, to, visit);
  }
}

/// Calls `visit(length, is_below)` for the stretches on either side of a level, in order. They add up to the length; their ends are
/// found to 1e-12 of it.
template <typename Function, typename Visitor>
void visit_stretches(const Function& f, double level, Visitor&& visit) {
  visit_stretches(f, level, -0.5 * f.length, 0.5 * f.length, visit);
}

}  // namespace alignability::detail
