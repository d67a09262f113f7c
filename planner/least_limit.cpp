// SPDX-License-Identifier: BSD-3-Clause
#include "planner/least_limit.hpp"

#include <algorithm>

namespace alignability {

std::optional<double> least_limit(const LimitRange& range, const std::function<bool(double)>& does, const std::stop_token& stop) {
  constexpr double kNear = 1e-3;
  double too_little = range.least;
  double enough = std::max(2.0 * range.least, kNear);
  for (; !does(enough); enough *= 2.0) {
    if (enough > range.most || stop.stop_requested()) return std::nullopt;
    too_little = enough;
  }
  while (enough - too_little > std::max(0.01 * enough, kNear)) {
    const double middle = 0.5 * (enough + too_little);
    (does(middle) ? enough : too_little) = middle;
  }
  return stop.stop_requested() ? std::nullopt : std::optional(enough);
}

}  // namespace alignability
