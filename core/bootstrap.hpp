// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

namespace alignability {

/// A figure of a sample and where it may as well have come out.
struct Interval {
  double value = 0.0;
  double low = 0.0;
  double high = 0.0;
};

struct BootstrapOptions {
  int resamples = 1000;
  double confidence = 0.95;
  std::uint64_t seed = 1;
};

/// A figure of `count` runs, told by their numbers from 0, and its percentile interval over samples of as many runs, drawn with replacement
/// (Efron and Tibshirani 1993). Samples without a figure, NaN, do not count; all is NaN where there are no runs. The same seed gives the
/// same interval. O(resamples) calls. Throws std::invalid_argument for options out of range.
Interval bootstrap(std::size_t count, const std::function<double(std::span<const std::size_t>)>& figure, const BootstrapOptions& options);

}  // namespace alignability
