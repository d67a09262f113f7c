// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>

#include "costmap/quadratic.hpp"

namespace alignability {

/// c0 + c1·s + c2·s² + c3·s³ for s in [0,1].
struct Cubic {
  double c0 = 0.0;
  double c1 = 0.0;
  double c2 = 0.0;
  double c3 = 0.0;

  /// From one quadratic to another, the latter's share going evenly from `begin` to `end`.
  static Cubic blend(const Quadratic& low, const Quadratic& high, double begin, double end) {
    const Quadratic rise{high.c0 - low.c0, high.c1 - low.c1, high.c2 - low.c2};
    const double grows = end - begin;
    return {low.c0 + begin * rise.c0, low.c1 + begin * rise.c1 + grows * rise.c0, low.c2 + begin * rise.c2 + grows * rise.c1,
            grows * rise.c2};
  }

  double at(double s) const { return c0 + s * (c1 + s * (c2 + s * c3)); }
  double mean() const { return c0 + c1 / 2.0 + c2 / 3.0 + c3 / 4.0; }
  bool is_number() const { return std::isfinite(c0) && std::isfinite(c1) && std::isfinite(c2) && std::isfinite(c3); }
  double least() const;
  /// Where in (0,1) it crosses a level, in order; 1 in place of a crossing that is not there.
  std::array<double, 3> crossings(double level) const;
};

}  // namespace alignability
