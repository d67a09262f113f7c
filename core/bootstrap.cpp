// SPDX-License-Identifier: BSD-3-Clause
#include "core/bootstrap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <stdexcept>
#include <vector>

#include "core/distribution.hpp"

namespace alignability {

Interval bootstrap(std::size_t count, const std::function<double(std::span<const std::size_t>)>& figure, const BootstrapOptions& options) {
  if (options.resamples < 1) throw std::invalid_argument("a bootstrap needs at least one resample");
  if (!(options.confidence > 0.0 && options.confidence < 1.0)) throw std::invalid_argument("a confidence must be in (0, 1)");
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  if (count == 0) return {kNone, kNone, kNone};
  std::vector<std::size_t> runs(count);
  std::iota(runs.begin(), runs.end(), std::size_t{0});
  const double value = figure(runs);
  std::mt19937_64 engine(options.seed);
  std::vector<double> figures;
  for (int i = 0; i < options.resamples; ++i) {
    for (std::size_t& run : runs) run = engine() % count;
    const double drawn = figure(runs);
    if (!std::isnan(drawn)) figures.push_back(drawn);
  }
  std::ranges::sort(figures);
  const double tail = 0.5 * (1.0 - options.confidence);
  return {value, quantile(figures, tail), quantile(figures, 1.0 - tail)};
}

}  // namespace alignability
