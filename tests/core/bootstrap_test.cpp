// SPDX-License-Identifier: BSD-3-Clause
#include "core/bootstrap.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

namespace alignability {
namespace {

double mean_of(const std::vector<double>& values, std::span<const std::size_t> runs) {
  double sum = 0.0;
  for (const std::size_t run : runs) sum += values[run];
  return sum / static_cast<double>(runs.size());
}

// The mean of n normal numbers lies within 1.96/√n of the truth nineteen times in twenty; a percentile bootstrap of 25 runs covers a little
// less.
TEST(Bootstrap, CoversTheTruthAboutAsOftenAsItSays) {
  std::mt19937_64 engine(1);
  std::normal_distribution<double> normal(3.0, 1.0);
  int covered = 0;
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<double> values(25);
    for (double& value : values) value = normal(engine);
    const Interval interval = bootstrap(values.size(), [&](auto runs) { return mean_of(values, runs); }, {.resamples = 400});
    EXPECT_LE(interval.low, interval.value);
    EXPECT_GE(interval.high, interval.value);
    covered += interval.low <= 3.0 && 3.0 <= interval.high ? 1 : 0;
  }
  EXPECT_GE(covered, 170);
  EXPECT_LE(covered, 198);
}

TEST(Bootstrap, OfOneRunKnowsNoSpread) {
  const Interval interval = bootstrap(1, [](auto runs) { return 2.0 + static_cast<double>(runs.front()); }, {});
  EXPECT_EQ(interval.value, 2.0);
  EXPECT_EQ(interval.low, 2.0);
  EXPECT_EQ(interval.high, 2.0);
}

TEST(Bootstrap, OfNoRunsIsNotANumberAndRefusesOptionsOutOfRange) {
  const auto zero = [](std::span<const std::size_t>) { return 0.0; };
  EXPECT_TRUE(std::isnan(bootstrap(0, zero, {}).value));
  EXPECT_THROW(bootstrap(1, zero, {.resamples = 0}), std::invalid_argument);
  for (const double confidence : {0.0, 1.0}) EXPECT_THROW(bootstrap(1, zero, {.confidence = confidence}), std::invalid_argument);
}

TEST(Bootstrap, PassesOverSamplesThatHaveNoFigure) {
  const auto figure = [](std::span<const std::size_t> runs) { return runs.front() == 0 ? std::numeric_limits<double>::quiet_NaN() : 5.0; };
  const Interval interval = bootstrap(4, figure, {});
  EXPECT_TRUE(std::isnan(interval.value));
  EXPECT_EQ(interval.low, 5.0);
  EXPECT_EQ(interval.high, 5.0);
}

TEST(Bootstrap, RepeatsWithItsSeed) {
  const std::vector<double> values{1.0, 2.0, 4.0, 8.0};
  const auto figure = [&](auto runs) { return mean_of(values, runs); };
  EXPECT_EQ(bootstrap(4, figure, {.seed = 3}).high, bootstrap(4, figure, {.seed = 3}).high);
}

}  // namespace
}  // namespace alignability
