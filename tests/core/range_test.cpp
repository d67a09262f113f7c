// SPDX-License-Identifier: BSD-3-Clause
#include "core/range.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <random>

namespace alignability {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(Range, HoldsItsEndsUnlessTheyAreOpen) {
  EXPECT_TRUE(kShare.contains(0.0));
  EXPECT_TRUE(kShare.contains(1.0));
  EXPECT_FALSE(kShare.contains(std::nextafter(1.0, 2.0)));
  EXPECT_FALSE(kShare.contains(-5e-324));
  EXPECT_FALSE(kPositive.contains(0.0));
  EXPECT_TRUE(kPositive.contains(5e-324));
  EXPECT_TRUE(kNotNegative.contains(0.0));
  EXPECT_TRUE(kNotNegative.contains(-0.0));
  const Range open{.min = 1.0, .max = 2.0, .min_end = Range::End::open, .max_end = Range::End::open};
  EXPECT_FALSE(open.contains(1.0));
  EXPECT_FALSE(open.contains(2.0));
  EXPECT_TRUE(open.contains(1.5));
}

TEST(Range, NeverHoldsNanOrInfinity) {
  for (const Range& range : {kFinite, kPositive, kNotNegative, kShare}) {
    EXPECT_FALSE(range.contains(kNaN));
    EXPECT_FALSE(range.contains(kInfinity));
    EXPECT_FALSE(range.contains(-kInfinity));
  }
  EXPECT_TRUE(kFinite.contains(std::numeric_limits<double>::max()));
  EXPECT_TRUE(kFinite.contains(std::numeric_limits<double>::lowest()));
}

TEST(Range, DescribesItselfInWords) {
  using enum Range::End;
  EXPECT_EQ(kFinite.description(), "a finite number");
  EXPECT_EQ(kPositive.description(), "greater than 0");
  EXPECT_EQ(kNotNegative.description(), "at least 0");
  EXPECT_EQ(kShare.description(), "from 0 to 1");
  EXPECT_EQ((Range{.max = 3.5}).description(), "at most 3.5");
  EXPECT_EQ((Range{.max = 3.5, .max_end = open}).description(), "less than 3.5");
  EXPECT_EQ((Range{.min = 0, .max = 90, .max_end = open}).description(), "at least 0 and less than 90");
  EXPECT_EQ((Range{.min = 0, .max = 90, .min_end = open}).description(), "greater than 0 and at most 90");
  EXPECT_EQ((Range{.min = 0, .max = 90, .min_end = open, .max_end = open}).description(), "greater than 0 and less than 90");
}

TEST(ToText, IsTheShortestThatPeopleWrite) {
  EXPECT_EQ(to_text(0.1), "0.1");
  EXPECT_EQ(to_text(2500.0), "2500");
  EXPECT_EQ(to_text(1e-9), "1e-09");
  EXPECT_EQ(to_text(-15.1), "-15.1");
  EXPECT_EQ(to_text(0.0), "0");
  EXPECT_EQ(to_text(kNaN), "nan");
  EXPECT_EQ(to_text(kInfinity), "inf");
  EXPECT_EQ(to_text(-kInfinity), "-inf");
  EXPECT_EQ(to_text(-std::numeric_limits<double>::denorm_min()), "-5e-324");
}

TEST(FixedText, RoundsAndGivesZeroNoSign) {
  EXPECT_EQ(fixed_text(-2.5, 1), "-2.5");
  EXPECT_EQ(fixed_text(-0.01, 1), "0.0");
  EXPECT_EQ(fixed_text(0.1 + 0.2, 1), "0.3");
  EXPECT_EQ(fixed_text(4800000.0, 0), "4800000");
}

TEST(ToText, ReadsBackAsTheSameDouble) {
  constexpr std::uint64_t kSeed = 20240611;
  SCOPED_TRACE(kSeed);
  std::mt19937_64 random(kSeed);
  for (int i = 0; i < 100000; ++i) {
    const double value = std::bit_cast<double>(random());
    if (!std::isfinite(value)) continue;
    const std::string text = to_text(value);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(std::strtod(text.c_str(), nullptr)), std::bit_cast<std::uint64_t>(value)) << text;
  }
}

}  // namespace
}  // namespace alignability
