// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace alignability {

/// What a sample of numbers looks like; NaN throughout for an empty one.
struct Distribution {
  double mean = 0.0;
  double min = 0.0;
  double median = 0.0;
  double p95 = 0.0;
  double max = 0.0;
};

/// O(n log n).
Distribution distribution_of(std::vector<double> values);

/// The quantile at a share in [0,1] of values in ascending order, linear between two of them (Hyndman & Fan 1996, type 7); NaN for none.
double quantile(const std::vector<double>& ascending, double share);

}  // namespace alignability
