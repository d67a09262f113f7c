// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace alignability {

/// c0 + c1·s + c2·s² for s in [0,1].
struct Quadratic {
  double c0 = 0.0;
  double c1 = 0.0;
  double c2 = 0.0;

  double at(double s) const { return c0 + s * (c1 + s * c2); }
  double mean() const { return c0 + c1 / 2.0 + c2 / 3.0; }
  bool is_number() const { return std::isfinite(c0) && std::isfinite(c1) && std::isfinite(c2); }

  double least() const {
    const double ends = std::min(at(0.0), at(1.0));
    const double bottom = c2 > 0.0 ? -c1 / (2.0 * c2) : -1.0;
    return bottom > 0.0 && bottom < 1.0 ? std::min(ends, at(bottom)) : ends;
  }

  /// Where in (0,1) it crosses a level, in order; 1 in place of a crossing that is not there.
  std::array<double, 2> crossings(double level) const {
    std::array<double, 2> shares{1.0, 1.0};
    std::size_t count = 0;
    const auto add = [&](double root) {
      if (root > 0.0 && root < 1.0) shares[count++] = root;
    };
    const double c = c0 - level;
    const double discriminant = c1 * c1 - 4.0 * c2 * c;
    if (c2 == 0.0) {
      if (c1 != 0.0) add(-c / c1);
    } else if (discriminant > 0.0) {
      // The form that does not cancel.
      const double half = -0.5 * (c1 + std::copysign(std::sqrt(discriminant), c1));
      add(half / c2);
      if (half != 0.0) add(c / half);
    }
    if (shares[0] > shares[1]) std::swap(shares[0], shares[1]);
    return shares;
  }
};

}  // namespace alignability
