// SPDX-License-Identifier: BSD-3-Clause
#include "planner/least_limit.hpp"

#include <algorithm>

namespace alignability {

std::optional<double> least_limit(const LimitRange& range, const std::function<bool(double)>& does, const StopTest& stop) {
  constexpr double kNear = 1e-3;
  double too_little = range.least;
  double enough = std::max(2.0 * range.least, kNear);
  for (; !does(enough); enough *= 2.0) {
    stop_if(stop);
    if (enough > range.most) return std::nullopt;
    too_little = enough;
  }
  while (enough - too_little > std::max(0.01 * enough, kNear)) {
    const double middle = 0.5 * (enough + too_little);
    (does(middle) ? enough : too_little) = middle;
  }
  stop_if(stop);
  return enough;
}

}  // namespace alignability
