// SPDX-License-Identifier: BSD-3-Clause
#include "costmap/risk_field.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "tests/costmap/ascii_map.hpp"

namespace alignability {
namespace {

using test::ascii_map;

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

AlignabilityMap map_of(const Grid<float>& alpha) {
  return {.geometry = alpha.geometry(), .layers = {{"alpha", alpha}}, .seed = 0, .options = {}, .sensor = {}, .provenance = {}};
}

AlignabilityMap row_of(const std::vector<float>& alpha, double resolution = 1.0) {
  return map_of(Grid<float>({.resolution = resolution, .width = static_cast<int>(alpha.size()), .height = 1}, alpha));
}

OccupancyMap free_row(std::size_t cells) { return ascii_map(1.0, {std::string(cells, '.')}); }

RiskField field_of(const std::vector<float>& alpha, const RiskOptions& options = {}) {
  return {row_of(alpha), free_row(alpha.size()), options};
}

double risk_at_alpha(float alpha) { return field_of({alpha}).risk(0.5, 0.5, 0.0); }

TEST(RiskField, IsOneUpToAlphaCriticalAndNoneFromAlphaSafe) {
  EXPECT_EQ(risk_at_alpha(0.0f), 1.0);
  EXPECT_EQ(risk_at_alpha(0.05f), 1.0);
  EXPECT_NEAR(risk_at_alpha(0.1f), 1.0, 1e-7);
  EXPECT_NEAR(risk_at_alpha(0.25f), 0.5, 1e-12);
  EXPECT_NEAR(risk_at_alpha(0.4f), 0.0, 1e-7);
  EXPECT_EQ(risk_at_alpha(1.0f), 0.0);
}

TEST(RiskField, IsLinearBetweenTheCentresOfCells) {
  const RiskField field = field_of({0.0f, 1.0f});
  EXPECT_EQ(field.risk(0.5, 0.5, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(field.risk(1.0, 0.5, 0.0), 0.5);
  EXPECT_EQ(field.risk(1.5, 0.5, 0.0), 0.0);
  EXPECT_DOUBLE_EQ(field.integral({0.5, 0.5, 0.0}, {1.5, 0.5, 0.0}), 0.5);
}

TEST(RiskField, TakesNoNoticeOfYaw) {
  const RiskField field = field_of({0.2f, 0.3f});
  EXPECT_EQ(field.risk(0.8, 0.5, 0.0), field.risk(0.8, 0.5, 2.0));
  EXPECT_EQ(field.integral({0.8, 0.5, 0.0}, {1.2, 0.5, 3.0}), field.integral({0.8, 0.5, 1.0}, {1.2, 0.5, 0.0}));
}

TEST(RiskField, StaysFromZeroToOneEverywhere) {
  constexpr std::uint64_t kSeed = 21;
  SCOPED_TRACE(kSeed);
  std::mt19937_64 random(kSeed);
  std::uniform_real_distribution<float> alpha;
  std::uniform_real_distribution<double> place(-2.0, 12.0);
  const GridGeometry geometry{.resolution = 1.0, .width = 10, .height = 10};
  Grid<float> cells(geometry, kNone);
  for (std::size_t i = 0; i < geometry.size(); ++i) cells[i] = i % 4 == 0 ? kNone : alpha(random);
  const OccupancyMap occupancy = test::random_map(random, {.resolution = 0.25, .width = 40, .height = 40}, 0.2);
  for (const UnknownPolicy policy : {UnknownPolicy::risky, UnknownPolicy::neutral, UnknownPolicy::blocked}) {
    const RiskField field(map_of(cells), occupancy, {.unknown = policy});
    for (int i = 0; i < 500; ++i) {
      const Pose2 a{place(random), place(random), 0.0};
      const Pose2 b{place(random), place(random), 0.0};
      EXPECT_GE(field.risk(a.x, a.y, 0.0), 0.0);
      EXPECT_LE(field.risk(a.x, a.y, 0.0), 1.0);
      EXPECT_GE(field.integral(a, b), 0.0);
      EXPECT_LE(field.integral(a, b), (a.position() - b.position()).norm() + 1e-12);
      EXPECT_EQ(field.integral(a, b), field.integral(b, a));
    }
  }
}

TEST(RiskField, ChargesAStripThinnerThanAnySampleOfALongEdge) {
  std::vector<float> alpha(1000, 0.9f);
  alpha[617] = 0.0f;
  const RiskField field(row_of(alpha, 0.05), ascii_map(0.05, {std::string(1000, '.')}), {});
  EXPECT_NEAR(field.integral({0.0, 0.02, 0.0}, {50.0, 0.02, 0.0}), 0.05, 1e-12);
  EXPECT_EQ(field.integral({0.0, 0.02, 0.0}, {30.0, 0.02, 0.0}), 0.0);
}

TEST(RiskField, TakesThePlacesNobodyKnowsAsThePolicySays) {
  const std::vector<float> alpha{0.9f, 0.9f, kNone, kNone, kNone, kNone};
  const RiskField risky = field_of(alpha, {.unknown = UnknownPolicy::risky});
  const RiskField neutral = field_of(alpha, {.unknown = UnknownPolicy::neutral});
  const RiskField blocked = field_of(alpha, {.unknown = UnknownPolicy::blocked});
  EXPECT_EQ(risky.risk(4.5, 0.5, 0.0), 1.0);
  EXPECT_EQ(neutral.risk(4.5, 0.5, 0.0), 0.0);
  EXPECT_EQ(blocked.risk(4.5, 0.5, 0.0), 1.0);
  for (const RiskField* field : {&risky, &neutral, &blocked}) {
    EXPECT_EQ(field->risk(2.5, 0.5, 0.0), 0.0) << "the ring around has the values of its neighbours";
    EXPECT_TRUE(std::isnan(field->alpha(4.5, 0.5, 0.0)));
    EXPECT_FALSE(std::isnan(field->alpha(2.2, 0.5, 0.0)));
  }
}

TEST(RiskField, IsBlindBelowAlphaCritical) {
  const RiskField risky = field_of({0.5f});
  EXPECT_TRUE(risky.is_blind(0.0));
  EXPECT_TRUE(risky.is_blind(std::nextafter(0.1, 0.0)));
  EXPECT_FALSE(risky.is_blind(0.1));
  EXPECT_TRUE(risky.is_blind(kNaN));
  EXPECT_FALSE(field_of({0.5f}, {.unknown = UnknownPolicy::neutral}).is_blind(kNaN));
  EXPECT_TRUE(field_of({0.5f}, {.unknown = UnknownPolicy::blocked}).is_blind(kNaN));
}

TEST(RiskField, IsDrivableEverywhereUnlessTheUnknownIsBlocked) {
  for (const UnknownPolicy policy : {UnknownPolicy::risky, UnknownPolicy::neutral}) {
    const RiskField field = field_of({0.9f, kNone, kNone, kNone}, {.unknown = policy});
    EXPECT_TRUE(field.is_drivable({3.5, 0.5}));
    EXPECT_TRUE(field.is_drivable({0.5, 0.5}, {3.5, 0.5}));
  }
}

TEST(RiskField, BlocksTheCellsBeyondTheRing) {
  const RiskField field = field_of({0.9f, kNone, kNone, kNone, 0.9f}, {.unknown = UnknownPolicy::blocked});
  EXPECT_TRUE(field.is_drivable({0.5, 0.5}));
  EXPECT_TRUE(field.is_drivable({1.5, 0.5}));
  EXPECT_FALSE(field.is_drivable({2.5, 0.5}));
  EXPECT_TRUE(field.is_drivable({3.5, 0.5}));
  EXPECT_FALSE(field.is_drivable({-0.5, 0.5})) << "off the map nothing is known";
  EXPECT_FALSE(field.is_drivable({kNaN, 0.5}));
  EXPECT_TRUE(field.is_drivable({0.1, 0.1}, {1.9, 0.9}));
  EXPECT_FALSE(field.is_drivable({1.5, 0.5}, {3.5, 0.5})) << "good ends, a blocked cell between";
  EXPECT_FALSE(field.is_drivable({3.5, 0.5}, {1.5, 0.5}));
  EXPECT_FALSE(field.is_drivable({0.5, 0.5}, {0.5, 1.5}));
}

TEST(RiskField, KeepsAboveTheFloorAndOutOfWhereNobodyKnows) {
  const RiskField field = field_of({0.9f, 0.9f, 0.2f, 0.9f, kNone, kNone, kNone}, {.min_alpha = 0.5});
  const Pose2 left{0.6, 0.5, 0.0}, right{3.5, 0.5, 0.0}, unknown{5.5, 0.5, 0.0};
  EXPECT_TRUE(field.is_drivable_along(left, {1.4, 0.5, 0.0}));
  EXPECT_FALSE(field.is_drivable_along(left, right)) << "good ends, a poor place between";
  EXPECT_FALSE(field.is_drivable_along(right, unknown));
  EXPECT_TRUE(field.is_drivable(Arc(left, 0.0, 0.8)));
  EXPECT_FALSE(field.is_drivable(Arc(left, 0.0, 2.9)));
  EXPECT_TRUE(field.is_drivable(Arc(left, 0.0, 0.0))) << "standing";
  EXPECT_FALSE(field.is_drivable(Arc(unknown, 0.0, 0.0)));
  const RiskField blocked = field_of({0.9f, 0.9f, kNone, kNone, kNone}, {.unknown = UnknownPolicy::blocked});
  EXPECT_TRUE(blocked.is_drivable(Arc(left, 0.0, 0.0)));
}

TEST(RiskField, RefusesThresholdsOutOfOrderOrRange) {
  for (const auto& [critical, safe] : {std::pair{0.4, 0.1}, {0.4, 0.4}, {-0.1, 0.4}, {0.1, 1.1}, {kNaN, 0.4}, {0.1, kNaN}}) {
    EXPECT_THROW(field_of({0.5f}, {.alpha_critical = critical, .alpha_safe = safe}), std::invalid_argument) << critical << ' ' << safe;
  }
  for (const double floor : {-0.1, 1.1, kNaN}) EXPECT_THROW(field_of({0.5f}, {.min_alpha = floor}), std::invalid_argument) << floor;
  EXPECT_NO_THROW(field_of({0.5f}, {.alpha_critical = 0.0, .alpha_safe = 1.0, .min_alpha = 1.0}));
}

}  // namespace
}  // namespace alignability
