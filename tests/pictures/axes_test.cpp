// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/axes.hpp"

#include <gmock/gmock.h>

namespace alignability::detail {
namespace {

using ::testing::DoubleNear;
using ::testing::Each;
using ::testing::ElementsAre;

TEST(Axes, StepsAreOneTwoOrFiveTimesAPowerOfTen) {
  EXPECT_DOUBLE_EQ(round_step(1.0), 1.0);
  EXPECT_DOUBLE_EQ(round_step(1.1), 2.0);
  EXPECT_DOUBLE_EQ(round_step(3.0), 5.0);
  EXPECT_DOUBLE_EQ(round_step(51.0), 100.0);
  EXPECT_DOUBLE_EQ(round_step(0.04), 0.05);
  EXPECT_DOUBLE_EQ(round_step(0.3 - 0.1), 0.2);
}

TEST(Axes, TicksIncludeBothEndsWhereTheyAreRound) {
  EXPECT_THAT(ticks_within({-10.0, 50.0}, 700.0, 110.0).values, ElementsAre(-10.0, 0.0, 10.0, 20.0, 30.0, 40.0, 50.0));
  const Ticks fine = ticks_within({0.0, 0.6}, 400.0, 110.0);
  EXPECT_EQ(fine.decimals, 1);
  EXPECT_THAT(fine.values, ElementsAre(0.0, 0.2, DoubleNear(0.4, 1e-12), DoubleNear(0.6, 1e-12)));
}

TEST(Axes, ALogarithmicAxisHasTicksAtOneTwoAndFiveOrAsManyAsFit) {
  const Span span{0.01, 2.0, AxisScale::logarithmic};
  const Ticks fine = ticks_within(span, 400.0, 70.0);
  EXPECT_THAT(fine.values, ElementsAre(0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0));
  EXPECT_EQ(fine.label(0.05), "0.05");
  EXPECT_THAT(ticks_within(span, 150.0, 70.0).values, ElementsAre(0.01, 0.1, 1.0));
  EXPECT_LT(ticks_within({1e-300, 1e300, AxisScale::logarithmic}, 400.0, 70.0).values.size(), 13u);
}

TEST(Axes, ARoundSpanHoldsItsValuesAndIsNoWiderThanItMust) {
  const auto ends = [](double least, double largest) {
    const Span span = round_span(least, largest);
    return std::pair{span.from, span.to};
  };
  using ::testing::Pair;
  EXPECT_THAT(ends(0.013, 1.7), Pair(DoubleNear(0.01, 1e-12), DoubleNear(2.0, 1e-12)));
  EXPECT_THAT(ends(0.05, 0.5), Pair(DoubleNear(0.05, 1e-12), DoubleNear(0.5, 1e-12)));
  EXPECT_THAT(ends(1.0, 1.0), Pair(DoubleNear(1.0, 1e-12), DoubleNear(2.0, 1e-12)));
  EXPECT_THAT(ends(0.0099, 0.3), Pair(DoubleNear(0.005, 1e-12), DoubleNear(0.5, 1e-12)));
}

TEST(Axes, ALogarithmicSpanSharesRatiosEvenly) {
  const Span span{0.01, 1.0, AxisScale::logarithmic};
  EXPECT_DOUBLE_EQ(span.share(0.1), 0.5);
  EXPECT_DOUBLE_EQ(span.share(1.0), 1.0);
  EXPECT_DOUBLE_EQ(span.share(0.0), 0.0);
  EXPECT_DOUBLE_EQ(span.share(-5.0), 0.0);
}

}  // namespace
}  // namespace alignability::detail
