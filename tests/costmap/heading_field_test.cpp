// SPDX-License-Identifier: BSD-3-Clause
#include "costmap/heading_field.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "tests/costmap/field_oracle.hpp"

namespace alignability {
namespace {

const GridGeometry kGrid{.resolution = 0.7, .origin = {-2.0, 1.0}, .width = 8, .height = 7};
constexpr double kTurn = 2.0 * std::numbers::pi;

double uniform(std::mt19937_64& random, double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); }

Pose2 random_pose(std::mt19937_64& random) { return {uniform(random, -2.5, 4.0), uniform(random, 0.5, 6.5), uniform(random, -3.2, 3.2)}; }

Arc random_arc(std::mt19937_64& random) {
  const double radius = std::pow(10.0, uniform(random, -1.0, 3.0));
  const double length = std::min(uniform(random, 0.0, 8.0), 7.0 * radius);
  return {random_pose(random), std::copysign(1.0 / radius, uniform(random, -1.0, 1.0)), std::copysign(length, uniform(random, -1.0, 1.0))};
}

HeadingField random_field(std::mt19937_64& random, std::size_t headings) {
  std::vector<BilinearField> fields;
  for (std::size_t k = 0; k < headings; ++k) fields.emplace_back(test::random_field(random, kGrid));
  return HeadingField(std::move(fields));
}

// As a sum over all headings, each times a tent that goes around.
double reference_value(const HeadingField& field, const Pose2& pose) {
  const double step = kTurn / static_cast<double>(field.at_headings().size());
  double sum = 0.0;
  for (std::size_t k = 0; k < field.at_headings().size(); ++k) {
    const double away = std::abs(normalized_angle(pose.yaw - static_cast<double>(k) * step)) / step;
    sum += std::max(0.0, 1.0 - away) * test::reference_value(field.at_headings()[k].nodes(), pose.position());
  }
  return sum;
}

// Gauss-Legendre between all places where the way passes from one patch or heading to the next, found by looking at 4000 of them.
// `at(share)`: the pose after that share of the way.
double mean_along(const HeadingField& field, const std::function<Pose2(double)>& at) {
  const auto piece = [&](double share) {
    const Pose2 pose = at(share);
    const Eigen::Array2d patch = ((pose.position() - kGrid.origin) / kGrid.resolution).array() - 0.5;
    return Eigen::Array3d(patch.x(), patch.y(), pose.yaw * static_cast<double>(field.at_headings().size()) / kTurn).floor().eval();
  };
  const auto differ = [&](double a, double b) { return (piece(a) != piece(b)).any(); };
  // Of the cuts within, wherever more than one is.
  std::vector<double> cuts;
  const std::function<void(double, double)> cut = [&](double low, double high) {
    const double middle = 0.5 * (low + high);
    if (!differ(low, high)) return;
    if (high - low < 1e-13 || middle == low || middle == high) return cuts.push_back(low);
    cut(low, middle);
    cut(middle, high);
  };
  constexpr int kLooks = 4000;
  for (int i = 0; i < kLooks; ++i) {
    cuts.push_back(static_cast<double>(i) / kLooks);
    cut(static_cast<double>(i) / kLooks, (i + 1.0) / kLooks);
  }
  cuts.push_back(1.0);
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const double half = 0.5 * (cuts[i + 1] - cuts[i]);
    for (const auto& [out, weight] : {std::pair{-std::sqrt(0.6), 5.0}, {0.0, 8.0}, {std::sqrt(0.6), 5.0}}) {
      sum += half * weight / 9.0 * reference_value(field, at(cuts[i] + half + out * half));
    }
  }
  return sum;
}

double expected_integral(const HeadingField& field, const Pose2& from, const Pose2& to) {
  return (to.position() - from.position()).norm() * mean_along(field, [&](double share) { return between(from, to, share); });
}

TEST(HeadingField, IsThatOfAHeadingThereAndLinearBetween) {
  std::mt19937_64 random(1);
  for (const std::size_t headings : {2u, 3u, 8u}) {
    const HeadingField field = random_field(random, headings);
    for (int i = 0; i < 300; ++i) {
      const Pose2 pose = random_pose(random);
      EXPECT_NEAR(field.at(pose), reference_value(field, pose), 1e-12);
      EXPECT_NEAR(field.at({pose.x, pose.y, pose.yaw + kTurn}), field.at(pose), 1e-12);
      const auto k = static_cast<std::size_t>(i) % headings;
      const double yaw = kTurn * static_cast<double>(k) / static_cast<double>(headings);
      EXPECT_NEAR(field.at({pose.x, pose.y, yaw}), field.at_headings()[k].at(pose.position()), 1e-12);
    }
  }
}

TEST(HeadingField, IntegratesSegmentsOnWhichYawTurnsTheShorterWay) {
  constexpr std::uint64_t kSeed = 2;
  SCOPED_TRACE(kSeed);
  std::mt19937_64 random(kSeed);
  for (int i = 0; i < 50; ++i) {
    const HeadingField field = random_field(random, i % 3 == 0 ? 2 : i % 3 == 1 ? 5 : 8);
    const Pose2 from = random_pose(random), to = random_pose(random);
    EXPECT_NEAR(field.integral(from, to), expected_integral(field, from, to), 1e-9);
    EXPECT_EQ(field.integral(from, to), field.integral(to, from)) << "the same to the bit";
  }
}

TEST(HeadingField, IntegratesSegmentsAlongLinesAndHeadings) {
  std::mt19937_64 random(3);
  const HeadingField field = random_field(random, 8);
  const auto heading = [](int k) { return kTurn / 8.0 * k; };
  const double line = kGrid.center({1, 1}).x();
  for (const auto& [from, to] : {std::pair{Pose2{line, 1.0, heading(1)}, Pose2{line, 5.0, heading(1)}},
                                 {Pose2{-2.0, 3.0, heading(0)}, Pose2{3.0, 3.0, heading(3)}},
                                 {Pose2{-2.0, 3.0, heading(5)}, Pose2{3.0, 4.0, heading(1)}},
                                 {Pose2{-9.0, 3.0, -3.0}, Pose2{9.0, 3.0, 3.0}},
                                 {Pose2{0.0, 3.0, 1.0}, Pose2{0.0, 3.0, 2.0}}}) {
    EXPECT_NEAR(field.integral(from, to), expected_integral(field, from, to), 1e-9);
    EXPECT_EQ(field.integral(from, to), field.integral(to, from));
  }
}

TEST(HeadingField, IntegratesArcsForwardAndBackward) {
  constexpr std::uint64_t kSeed = 4;
  SCOPED_TRACE(kSeed);
  std::mt19937_64 random(kSeed);
  for (int i = 0; i < 50; ++i) {
    const HeadingField field = random_field(random, i % 2 == 0 ? 3 : 8);
    const Arc arc = random_arc(random);
    const double expected = arc.length() * mean_along(field, [&](double share) { return arc.at(share * arc.length()); });
    EXPECT_NEAR(field.integral(arc), expected, 1e-9);
    EXPECT_NEAR(field.integral({arc.end(), arc.curvature, -arc.travel}), field.integral(arc), 1e-10) << "the same way back";
    const double cut = 0.3 * arc.length();
    EXPECT_NEAR(field.integral(arc.piece(0.0, cut)) + field.integral(arc.piece(cut, arc.length())), field.integral(arc), 1e-10);
  }
}

TEST(HeadingField, OfOneAndTheSameFieldAtAllHeadingsIsThatField) {
  std::mt19937_64 random(5);
  const BilinearField plain(test::random_field(random, kGrid));
  const HeadingField field(std::vector<BilinearField>(8, plain));
  for (int i = 0; i < 200; ++i) {
    const Pose2 from = random_pose(random), to = random_pose(random);
    const Arc arc = random_arc(random);
    EXPECT_NEAR(field.at(from), plain.at(from.position()), 1e-14);
    EXPECT_NEAR(field.integral(from, to), plain.integral(from.position(), to.position()), 1e-12);
    EXPECT_NEAR(field.integral(arc), plain.integral(arc), 1e-12);
  }
}

TEST(HeadingField, KnowsItsPiecesOfASegment) {
  std::mt19937_64 random(6);
  for (int i = 0; i < 100; ++i) {
    const HeadingField field = random_field(random, 6);
    const Pose2 from = random_pose(random), to = random_pose(random);
    double done = 0.0;
    field.visit(from, to, [&](double share, const Cubic& along) {
      for (const double s : {0.0, 0.3, 0.8, 1.0}) EXPECT_NEAR(along.at(s), field.at(between(from, to, done + s * share)), 1e-9);
      double least = 1.0;
      for (int k = 0; k <= 1000; ++k) least = std::min(least, along.at(k / 1000.0));
      EXPECT_LE(along.least(), least);
      EXPECT_NEAR(along.least(), least, 1e-4);
      for (const double level : along.crossings(0.5)) {
        EXPECT_TRUE(level == 1.0 || std::abs(along.at(level) - 0.5) < 1e-12);
      }
      done += share;
    });
    EXPECT_NEAR(done, 1.0, 1e-12);
  }
}

TEST(HeadingField, KnowsItsLeastAlongAnArcAndWhereItIsBelowALevel) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 60; ++i) {
    const HeadingField field = random_field(random, 5);
    const Arc arc = random_arc(random);
    double least = 1.0, below = 0.0, looked_least = 1.0, looked_below = 0.0;
    field.visit(arc, [&](const BlendAlongArc& piece) {
      least = std::min(least, piece.least());
      piece.visit_stretches(0.4, [&](double length, bool is_below) { below += is_below ? length : 0.0; });
    });
    constexpr int kLooks = 20'000;
    for (int k = 0; k < kLooks; ++k) {
      const double here = field.at(arc.at(arc.length() * (k + 0.5) / kLooks));
      looked_least = std::min(looked_least, here);
      if (here < 0.4) looked_below += arc.length() / kLooks;
    }
    EXPECT_LE(least, looked_least + 1e-11);
    EXPECT_NEAR(least, looked_least, 1e-3);
    EXPECT_NEAR(below, looked_below, 20.0 * arc.length() / kLooks);
  }
}

TEST(HeadingField, ReachesALevelWhereAtEachPointSomeHeadingDoes) {
  constexpr std::uint64_t kSeed = 8;
  SCOPED_TRACE(kSeed);
  std::mt19937_64 random(kSeed);
  int reached = 0;
  for (int i = 0; i < 400; ++i) {
    const HeadingField field = random_field(random, 3);
    const Pose2 from = random_pose(random);
    const Eigen::Vector2d a = from.position(), b = a + Eigen::Vector2d(uniform(random, -1.0, 1.0), uniform(random, -1.0, 1.0));
    double least = 1.0;
    for (int k = 0; k <= 2000; ++k) {
      double most = 0.0;
      for (const BilinearField& one : field.at_headings()) most = std::max(most, one.at(a + k / 2000.0 * (b - a)));
      least = std::min(least, most);
    }
    EXPECT_TRUE(field.reaches(least - 2e-3, a, b));
    EXPECT_FALSE(field.reaches(least + 1e-9, a, b));
    reached += field.reaches(0.5, a, b) ? 1 : 0;
  }
  EXPECT_GT(reached, 50);
  EXPECT_LT(reached, 350);
}

TEST(HeadingField, RefusesOneHeadingAndSeveralGrids) {
  std::mt19937_64 random(9);
  const BilinearField one(test::random_field(random, kGrid));
  GridGeometry finer = kGrid;
  finer.resolution = 0.5;
  EXPECT_THROW(HeadingField(std::vector{one}), std::invalid_argument);
  EXPECT_THROW(HeadingField(std::vector{one, BilinearField(test::random_field(random, finer))}), std::invalid_argument);
}

// To 1e17 a heading more changes nothing.
TEST(HeadingField, AYawOfManyTurnsIsTakenForWhereItPoints) {
  std::mt19937_64 random(7);
  const HeadingField field = random_field(random, 8);
  for (const double yaw : {1e6, -1e9, 1e17}) {
    const Pose2 from{-1.0, 2.0, yaw}, to{3.0, 5.0, yaw};
    const Pose2 small_from{-1.0, 2.0, normalized_angle(yaw)}, small_to{3.0, 5.0, normalized_angle(yaw)};
    EXPECT_NEAR(field.integral(from, to), field.integral(small_from, small_to), 1e-9);
  }
}

TEST(HeadingField, HasNoValueWhereTheYawIsNoNumber) {
  std::mt19937_64 random(5);
  const HeadingField field = random_field(random, 4);
  for (const double yaw : {std::numeric_limits<double>::infinity(), std::nan("")}) EXPECT_TRUE(std::isnan(field.at({1.0, 3.0, yaw})));
}

TEST(HeadingField, AnArcOfNoLengthAddsNothing) {
  std::mt19937_64 random(5);
  const HeadingField field = random_field(random, 4);
  EXPECT_EQ(field.integral(Arc({1.0, 3.0, 0.5}, 0.7, 0.0)), 0.0);
  EXPECT_EQ(field.at_headings().front().integral(Arc({1.0, 3.0, 0.5}, 0.7, 0.0)), 0.0);
}

TEST(HeadingField, ReachesNoLevelWhereNoHeadingHasAValue) {
  Grid<double> nodes(kGrid, 1.0);
  for (int y = 0; y < kGrid.height; ++y) nodes[Cell{4, y}] = std::nan("");
  const HeadingField field(std::vector{BilinearField(nodes), BilinearField(nodes)});
  EXPECT_TRUE(field.reaches(0.5, kGrid.center({1, 1}), kGrid.center({3, 1})));
  EXPECT_FALSE(field.reaches(0.5, kGrid.center({1, 1}), kGrid.center({6, 1})));
}

}  // namespace
}  // namespace alignability
