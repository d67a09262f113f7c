// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/blind_stretches.hpp"

#include <gmock/gmock.h>

#include <limits>

namespace alignability::detail {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
const RiskOptions kRisk{.alpha_critical = 0.1, .alpha_safe = 0.4, .unknown = UnknownPolicy::risky};

std::vector<std::pair<double, double>> stretches(std::vector<ProfilePoint> profile, const RiskOptions& risk = kRisk) {
  std::vector<std::pair<double, double>> pairs;
  for (const Stretch& stretch : blind_stretches(profile, risk)) pairs.emplace_back(stretch.from, stretch.to);
  return pairs;
}

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Pair;

TEST(BlindStretches, BeginAndEndWhereAlphaCrossesTheThreshold) {
  EXPECT_THAT(stretches({{0.0, 0.3}, {4.0, 0.05}, {6.0, 0.05}, {7.0, 0.15}}),
              ElementsAre(Pair(DoubleNear(3.2, 1e-12), DoubleNear(6.5, 1e-12))));
}

TEST(BlindStretches, TheThresholdItselfIsNotBlind) { EXPECT_THAT(stretches({{0.0, 0.1}, {5.0, 0.1}}), IsEmpty()); }

TEST(BlindStretches, APathCanBeBlindThroughout) {
  EXPECT_THAT(stretches({{0.0, 0.0}, {1.0, 0.01}, {2.0, 0.0}}), ElementsAre(Pair(0.0, 2.0)));
}

TEST(BlindStretches, TwoOfThemStayApart) {
  EXPECT_THAT(stretches({{0.0, 0.0}, {1.0, 0.2}, {2.0, 0.0}}), ElementsAre(Pair(0.0, 0.5), Pair(1.5, 2.0)));
}

TEST(BlindStretches, TheUnknownIsBlindUnderTheRiskyPolicyOnly) {
  const std::vector<ProfilePoint> profile = {{0.0, 0.5}, {1.0, kNaN}, {2.0, kNaN}, {3.0, 0.5}};
  EXPECT_THAT(stretches(profile), ElementsAre(Pair(0.5, 2.5)));
  for (const UnknownPolicy policy : {UnknownPolicy::neutral, UnknownPolicy::blocked}) {
    EXPECT_THAT(stretches(profile, {.alpha_critical = 0.1, .alpha_safe = 0.4, .unknown = policy}), IsEmpty());
  }
}

TEST(BlindStretches, AProfileOfLessThanTwoPointsHasNone) {
  EXPECT_THAT(stretches({}), IsEmpty());
  EXPECT_THAT(stretches({{0.0, 0.0}}), IsEmpty());
}

TEST(PartOf, KeepsTheCornersBetweenBothEnds) {
  const std::vector<Pose2> poses = {{0.0, 0.0}, {2.0, 0.0}, {2.0, 2.0}};
  const auto part = part_of(poses, 0.25, 0.75);
  ASSERT_EQ(part.size(), 3u);
  EXPECT_TRUE(part[0].isApprox(Eigen::Vector2d(1.0, 0.0)));
  EXPECT_TRUE(part[1].isApprox(Eigen::Vector2d(2.0, 0.0)));
  EXPECT_TRUE(part[2].isApprox(Eigen::Vector2d(2.0, 1.0)));
}

TEST(PartOf, IsEmptyForAPathThatGoesNowhere) {
  const std::vector<Pose2> turn = {{1.0, 1.0, 0.0}, {1.0, 1.0, 3.0}};
  EXPECT_THAT(part_of(turn, 0.0, 1.0), IsEmpty());
  EXPECT_THAT(part_of({}, 0.0, 1.0), IsEmpty());
}

}  // namespace
}  // namespace alignability::detail
