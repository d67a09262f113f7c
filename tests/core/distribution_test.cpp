// SPDX-License-Identifier: BSD-3-Clause
#include "core/distribution.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace alignability {
namespace {

TEST(Distribution, OfAHundredAndOneNumbersHasItsPercentilesAmongThem) {
  std::vector<double> values;
  for (int i = 100; i >= 0; --i) values.push_back(i);
  const Distribution distribution = distribution_of(values);
  EXPECT_DOUBLE_EQ(distribution.mean, 50.0);
  EXPECT_EQ(distribution.min, 0.0);
  EXPECT_DOUBLE_EQ(distribution.median, 50.0);
  EXPECT_NEAR(distribution.p95, 95.0, 1e-12);
  EXPECT_EQ(distribution.max, 100.0);
}

TEST(Distribution, LiesBetweenTwoNumbersWhereTheShareDoes) {
  EXPECT_DOUBLE_EQ(quantile({1.0, 3.0}, 0.25), 1.5);
  EXPECT_EQ(quantile({7.0}, 0.95), 7.0);
}

TEST(Distribution, OfNothingIsNotANumber) {
  const Distribution nothing = distribution_of({});
  EXPECT_TRUE(std::isnan(nothing.mean));
  EXPECT_TRUE(std::isnan(nothing.median));
  EXPECT_TRUE(std::isnan(nothing.p95));
}

}  // namespace
}  // namespace alignability
