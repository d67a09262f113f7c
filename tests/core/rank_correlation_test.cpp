// SPDX-License-Identifier: BSD-3-Clause
#include "core/rank_correlation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace alignability {
namespace {

using Values = std::vector<double>;

TEST(RankCorrelation, IsOneAlongAnyRisingCurveAndMinusOneAlongAFallingOne) {
  const Values x{0.1, 0.2, 3.0, 40.0};
  EXPECT_DOUBLE_EQ(rank_correlation(x, Values{1.0, 10.0, 11.0, 1e9}), 1.0);
  EXPECT_DOUBLE_EQ(rank_correlation(x, Values{4.0, 3.0, 2.0, -7.0}), -1.0);
}

// 1 − 6·Σd²/(n(n² − 1)) for ranks without ties: d = 1, 1, 1, 1 and 0 among five.
TEST(RankCorrelation, IsSpearmansFormulaWithoutTies) {
  EXPECT_NEAR(rank_correlation(Values{1, 2, 3, 4, 5}, Values{2, 1, 4, 3, 5}), 1.0 - 6.0 * 4.0 / (5.0 * 24.0), 1e-15);
}

TEST(RankCorrelation, GivesEqualValuesTheMeanOfTheirRanks) {
  EXPECT_EQ(ranks_of(Values{7.0, 1.0, 7.0, 9.0}), (Values{1.5, 0.0, 1.5, 3.0}));
}

TEST(RankCorrelation, IsNotANumberWhereThereIsNoneToTell) {
  EXPECT_TRUE(std::isnan(rank_correlation(Values{}, Values{})));
  EXPECT_TRUE(std::isnan(rank_correlation(Values{1.0}, Values{2.0})));
  EXPECT_TRUE(std::isnan(rank_correlation(Values{1.0, 1.0}, Values{2.0, 3.0})));
  EXPECT_THROW(rank_correlation(Values{1.0, 2.0}, Values{2.0}), std::invalid_argument);
}

}  // namespace
}  // namespace alignability
