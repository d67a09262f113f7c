// SPDX-License-Identifier: BSD-3-Clause
#include "costmap/cubic.hpp"

namespace alignability {
namespace {

// The places in (0,1) at which it may turn, in order; 1 in place of others.
std::array<double, 2> turning_points(const Cubic& cubic) { return Quadratic{cubic.c1, 2.0 * cubic.c2, 3.0 * cubic.c3}.crossings(0.0); }

// Between two places, on either side of the level, with no turn between: to the last bit.
double crossing_between(const Cubic& cubic, double level, double low, double high) {
  const bool is_below = cubic.at(low) < level;
  for (;;) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) return middle;
    ((cubic.at(middle) < level) == is_below ? low : high) = middle;
  }
}

}  // namespace

double Cubic::least() const {
  const auto [first, second] = turning_points(*this);
  return std::min({at(0.0), at(first), at(second), at(1.0)});
}

std::array<double, 3> Cubic::crossings(double level) const {
  const auto [first, second] = turning_points(*this);
  const std::array ends{0.0, first, second, 1.0};
  std::array<double, 3> shares{1.0, 1.0, 1.0};
  std::size_t count = 0;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    if ((at(ends[i]) < level) != (at(ends[i + 1]) < level)) shares[count++] = crossing_between(*this, level, ends[i], ends[i + 1]);
  }
  return shares;
}

}  // namespace alignability
