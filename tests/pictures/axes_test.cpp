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
  EXPECT_THAT(ticks_within(-10.0, 50.0, 700.0, 110.0).values, ElementsAre(-10.0, 0.0, 10.0, 20.0, 30.0, 40.0, 50.0));
  const Ticks fine = ticks_within(0.0, 0.6, 400.0, 110.0);
  EXPECT_EQ(fine.decimals, 1);
  EXPECT_THAT(fine.values, ElementsAre(0.0, 0.2, DoubleNear(0.4, 1e-12), DoubleNear(0.6, 1e-12)));
}

}  // namespace
}  // namespace alignability::detail
