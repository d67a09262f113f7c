// SPDX-License-Identifier: BSD-3-Clause
#include "core/arc.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "costmap/bilinear_field.hpp"
#include "costmap/clearance_map.hpp"
#include "costmap/risk_field.hpp"
#include "tests/costmap/ascii_map.hpp"
#include "tests/costmap/field_oracle.hpp"
#include "tests/costmap/segment_oracle.hpp"

namespace alignability {
namespace {

const GridGeometry kGrid{.resolution = 0.7, .origin = {-2.0, 1.0}, .width = 8, .height = 7};

double uniform(std::mt19937_64& random, double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); }

Arc random_arc(std::mt19937_64& random, double longest) {
  const double radius = std::pow(10.0, uniform(random, -1.3, 3.0));
  const double curvature = std::copysign(1.0 / radius, uniform(random, -1.0, 1.0));
  const double length = std::min(uniform(random, 0.0, longest), 7.0 * radius);
  return {{uniform(random, -2.5, 4.0), uniform(random, 0.5, 6.5), uniform(random, -3.2, 3.2)},
          curvature,
          std::copysign(length, uniform(random, -1.0, 1.0))};
}

// By steps along the tangent's own turning: none of the arc's formulas.
Pose2 driven(const Arc& arc) {
  constexpr int kSteps = 100'000;
  const double step = arc.travel / kSteps;
  Eigen::Vector2d at = arc.start.position();
  for (int i = 0; i < kSteps; ++i) {
    const double yaw = arc.start.yaw + (i + 0.5) * step * arc.curvature;
    at += step * Eigen::Vector2d(std::cos(yaw), std::sin(yaw));
  }
  return {at.x(), at.y(), arc.start.yaw + arc.travel * arc.curvature};
}

// Gauss-Legendre between all crossings with the lines through the centres, found by looking every few millimetres.
double quadrature(const Grid<double>& nodes, const Arc& arc) {
  const auto patch = [&](double s) {
    const Eigen::Vector2d at = (arc.at(s).position() - nodes.geometry().origin) / nodes.geometry().resolution;
    return Eigen::Vector2d((at.array() - 0.5).floor());
  };
  std::vector<double> cuts{0.0};
  constexpr int kLooks = 4000;
  for (int i = 0; i < kLooks; ++i) {
    double low = arc.length() * i / kLooks;
    double high = arc.length() * (i + 1) / kLooks;
    if (patch(low) != patch(high)) {
      while (high - low > 1e-13) {
        const double middle = 0.5 * (low + high);
        if (middle == low || middle == high) break;
        (patch(middle) == patch(low) ? low : high) = middle;
      }
      cuts.push_back(low);
    }
    if (i % 40 == 39) cuts.push_back(arc.length() * (i + 1) / kLooks);
  }
  const double outer = std::sqrt(0.6);
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const double half = 0.5 * (cuts[i + 1] - cuts[i]);
    for (const auto& [at, weight] : {std::pair{-outer, 5.0}, {0.0, 8.0}, {outer, 5.0}}) {
      sum += half * weight / 9.0 * test::reference_value(nodes, arc.at(cuts[i] + half + at * half).position());
    }
  }
  return sum;
}

TEST(Arc, EndsWhereDrivingAlongItsTangentEnds) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 50; ++i) {
    const Arc arc = random_arc(random, 10.0);
    const Pose2 expected = driven(arc);
    EXPECT_NEAR((arc.end().position() - expected.position()).norm(), 0.0, 1e-7);
    EXPECT_NEAR(arc.end().yaw, expected.yaw, 1e-12);
    const double s = uniform(random, 0.0, arc.length());
    EXPECT_NEAR((arc.piece(s, arc.length()).end().position() - arc.end().position()).norm(), 0.0, 1e-11);
    EXPECT_NEAR(arc.piece(0.0, s).length() + arc.piece(s, arc.length()).length(), arc.length(), 1e-12);
  }
}

TEST(Arc, LeavesItsChordByItsBulgeInTheMiddle) {
  const Arc arc{{1.0, 2.0, 0.5}, -0.5, 3.0};
  const Eigen::Vector2d chord = 0.5 * (arc.start.position() + arc.end().position());
  EXPECT_NEAR((arc.at(1.5).position() - chord).norm(), arc.bulge(), 1e-12);
  EXPECT_EQ((Arc{{1.0, 2.0, 0.5}, 0.0, 3.0}).bulge(), 0.0);
}

TEST(BilinearFieldAlongAnArc, IntegratesExactly) {
  constexpr std::uint64_t kSeed = 4;
  SCOPED_TRACE(kSeed);
  std::mt19937_64 random(kSeed);
  for (int i = 0; i < 300; ++i) {
    const BilinearField field(test::random_field(random, kGrid));
    const Arc arc = random_arc(random, 12.0);
    EXPECT_NEAR(field.integral(arc), quadrature(field.nodes(), arc), 1e-9 * arc.length() + 1e-12)
        << arc.start.x << ' ' << arc.start.y << ' ' << arc.start.yaw << ' ' << 1.0 / arc.curvature << ' ' << arc.travel;
  }
}

TEST(BilinearFieldAlongAnArc, IntegratesExactlyWhereTheArcStartsOnLinesAndTouchesThem) {
  std::mt19937_64 random(5);
  const BilinearField field(test::random_field(random, kGrid));
  for (int quarter = 0; quarter < 4; ++quarter) {
    for (const double cells : {0.5, 1.0, 1.5, 2.0}) {
      for (const double side : {-1.0, 1.0}) {
        const Eigen::Vector2d node = kGrid.center({4, 3});
        const double radius = cells * kGrid.resolution;
        const Arc arc{{node.x(), node.y(), quarter * 0.5 * std::numbers::pi}, side / radius, 2.0 * std::numbers::pi * radius};
        EXPECT_NEAR(field.integral(arc), quadrature(field.nodes(), arc), 1e-9 * arc.length()) << quarter << ' ' << cells << ' ' << side;
      }
    }
  }
}

TEST(BilinearFieldAlongAnArc, IsTheSameBackwardAndInPieces) {
  std::mt19937_64 random(6);
  const BilinearField field(test::random_field(random, kGrid));
  for (int i = 0; i < 500; ++i) {
    const Arc arc = random_arc(random, 12.0);
    const Arc back{arc.end(), arc.curvature, -arc.travel};
    EXPECT_NEAR(field.integral(back), field.integral(arc), 1e-11 * (1.0 + arc.length()));
    const double s = uniform(random, 0.0, arc.length());
    EXPECT_NEAR(field.integral(arc.piece(0.0, s)) + field.integral(arc.piece(s, arc.length())), field.integral(arc),
                1e-11 * (1.0 + arc.length()));
  }
}

TEST(BilinearFieldAlongAnArc, IsThatOfASegmentWhenItIsStraight) {
  std::mt19937_64 random(7);
  const BilinearField field(test::random_field(random, kGrid));
  for (int i = 0; i < 200; ++i) {
    Arc arc = random_arc(random, 12.0);
    arc.curvature = 0.0;
    EXPECT_NEAR(field.integral(arc), field.integral(arc.start.position(), arc.end().position()), 1e-12 * (1.0 + arc.length()));
  }
}

TEST(BilinearFieldAlongAnArc, KnowsItsLeastAndWhereItIsBelowALevel) {
  std::mt19937_64 random(8);
  const BilinearField field(test::random_field(random, kGrid));
  for (int i = 0; i < 60; ++i) {
    const Arc arc = random_arc(random, 8.0);
    constexpr int kSamples = 20'000;
    double least = 2.0;
    int below = 0;
    for (int k = 0; k < kSamples; ++k) {
      const double value = field.at(arc.at(arc.length() * (k + 0.5) / kSamples).position());
      least = std::min(least, value);
      below += value < 0.45 ? 1 : 0;
    }
    double found_least = 2.0;
    double found_below = 0.0;
    double length = 0.0;
    field.visit(arc, [&](const BilinearAlongArc& piece) {
      found_least = std::min(found_least, piece.least());
      piece.visit_stretches(0.45, [&](double stretch, bool is_below) {
        length += stretch;
        if (is_below) found_below += stretch;
      });
    });
    EXPECT_NEAR(length, arc.length(), 1e-12 + 1e-12 * arc.length());
    EXPECT_NEAR(found_below, arc.length() * below / kSamples, 20.0 * arc.length() / kSamples);
    EXPECT_LE(found_least, least + 1e-11);
    // What falls between two samples is no steeper than √2 a cell.
    EXPECT_GE(found_least, least - std::numbers::sqrt2 / kGrid.resolution * 0.5 * arc.length() / kSamples);
  }
}

TEST(BilinearFieldAlongAnArc, MeetsALevelThatItTouchesOrKeepsTo) {
  const BilinearAlongArc touching{.length = 1.0, .curvature = 2.0, .value = 0.3, .gradient = {0.0, 1.0}};
  double below = 0.0;
  touching.visit_stretches(0.3, [&](double stretch, bool is_below) { below += is_below ? stretch : 0.0; });
  EXPECT_NEAR(below, 0.0, 1e-9);
  const BilinearAlongArc bending_less_than_it_may{.length = 1.0, .curvature = 2.0, .value = 0.3, .gradient = {0.0, 1.0}, .twist = 1.0};
  below = 0.0;
  bending_less_than_it_may.visit_stretches(0.3, [&](double stretch, bool is_below) { below += is_below ? stretch : 0.0; });
  EXPECT_NEAR(below, 0.0, 1e-9);
  const BilinearAlongArc flat{.length = 1.0, .curvature = 2.0, .value = 0.3};
  flat.visit_stretches(0.3, [&](double stretch, bool is_below) {
    EXPECT_EQ(stretch, 1.0);
    EXPECT_FALSE(is_below);
  });
}

// As along the centres of a row of cells that all have the level, where the next row's differ.
TEST(BilinearFieldAlongAnArc, TellsInOnePieceThatItKeepsToALevelWhichItLeavesAside) {
  for (const double curvature : {0.0, 1e-9}) {
    const BilinearAlongArc level{.length = 1.0, .curvature = curvature, .value = 0.25, .gradient = {0.0, 0.5}, .twist = 1.0};
    int pieces = 0;
    double length = 0.0;
    level.visit_stretches(0.25, [&](double stretch, bool) {
      length += stretch;
      if (++pieces > 1000) throw std::runtime_error("too many pieces");
    });
    EXPECT_NEAR(length, 1.0, 1e-12);
  }
}

TEST(ClearanceOfAnArc, AgreesWithBruteForceToAThousandthOfACell) {
  constexpr std::uint64_t kSeed = 9;
  SCOPED_TRACE(kSeed);
  std::mt19937_64 random(kSeed);
  int clear = 0;
  int blocked = 0;
  for (int site = 0; site < 10; ++site) {
    const OccupancyMap map = test::random_map(random, {.resolution = 0.2, .origin = {-2.5, 0.5}, .width = 32, .height = 30}, 0.015);
    const ClearanceMap clearance(map);
    for (int i = 0; i < 40; ++i) {
      const Arc arc = random_arc(random, 4.0);
      const double radius = uniform(random, 0.05, 0.6);
      double least = 1e9;
      const int looks = static_cast<int>(arc.length() / 1e-3) + 1;
      for (int k = 0; k <= looks; ++k)
        least = std::min(least, test::brute_force_distance(map, arc.at(arc.length() * k / looks).position()));
      const bool is_clear = clearance.is_clear(arc, radius);
      if (is_clear) {
        EXPECT_GE(least, radius);
      }
      // Between two looks it comes nearer by half a millimetre at most.
      if (least >= radius + 1e-3 * 0.2 + 0.5e-3) {
        EXPECT_TRUE(is_clear) << least - radius;
      }
      ++(is_clear ? clear : blocked);
    }
  }
  EXPECT_GT(clear, 40);
  EXPECT_GT(blocked, 100);
}

TEST(ClearanceOfAnArc, LetsADiskDriveRoundAPostThatItAllButTouches) {
  const ClearanceMap clearance(test::ascii_map(1.0, {".......", ".......", ".......", "...#...", ".......", ".......", "......."}));
  const double radius = 1.0;
  // About the post's corner (4, 4): the disk's edge at that distance from it.
  for (const double gap : {2e-3, -2e-3}) {
    const Arc arc{{4.0 + radius + gap, 4.0, 0.5 * std::numbers::pi}, 1.0 / (radius + gap), 0.5 * std::numbers::pi * (radius + gap)};
    EXPECT_EQ(clearance.is_clear(arc, radius), gap > 0.0);
  }
}

TEST(ClearanceOfAnArc, IsRefusedWhereItClearsByLessThanAHair) {
  const ClearanceMap clearance(test::ascii_map(1.0, {".......", ".......", ".......", "...#...", ".......", ".......", "......."}));
  const double about = 1.0 + 1e-7;
  const Arc arc{{4.0 + about, 4.0, 0.5 * std::numbers::pi}, 1.0 / about, 0.5 * std::numbers::pi * about};
  EXPECT_FALSE(clearance.is_clear(arc, 1.0));
  EXPECT_TRUE(clearance.is_clear(arc, 0.99));
}

TEST(ClearanceOfAnArc, IsThatOfASegmentWhenItIsStraight) {
  const ClearanceMap clearance(test::ascii_map(1.0, {".......", "...#...", "......."}));
  EXPECT_TRUE(clearance.is_clear(Arc({1.0, 0.5, 0.0}, 0.0, 5.0), 0.4));
  EXPECT_FALSE(clearance.is_clear(Arc({1.0, 1.5, 0.0}, 0.0, 5.0), 0.4));
}

TEST(RiskFieldAlongAnArc, KeepsOutOfWhatIsUnknownAndBlocked) {
  Grid<float> alpha({.resolution = 1.0, .origin = {0.0, 0.0}, .width = 9, .height = 9}, 0.5f);
  for (int y = 3; y < 6; ++y) {
    for (int x = 3; x < 6; ++x) alpha[Cell{x, y}] = std::numeric_limits<float>::quiet_NaN();
  }
  AlignabilityMap map;
  map.geometry = alpha.geometry();
  map.layers.push_back({"alpha", alpha});
  const OccupancyMap occupancy(Grid<float>(alpha.geometry(), 0.0f));
  const RiskField risk(map, occupancy, {.unknown = UnknownPolicy::blocked});
  // Border cells are filled: cell (4, 4) alone is blocked.
  const Arc through{{3.0, 3.5, 0.5 * std::numbers::pi}, -1.0 / 1.5, 1.5 * std::numbers::pi};
  const Arc around{{2.0, 4.5, 0.5 * std::numbers::pi}, -1.0 / 2.5, 5.0 * std::numbers::pi};
  EXPECT_TRUE(risk.is_drivable(through.start.position()));
  EXPECT_TRUE(risk.is_drivable(through.end().position()));
  EXPECT_FALSE(risk.is_drivable(through));
  EXPECT_TRUE(risk.is_drivable(around));
}

}  // namespace
}  // namespace alignability
