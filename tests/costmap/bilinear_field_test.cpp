// SPDX-License-Identifier: BSD-3-Clause
#include "costmap/bilinear_field.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <limits>
#include <random>

#include "tests/costmap/field_oracle.hpp"

namespace alignability {
namespace {

using test::quadrature;
using test::random_field;
using test::reference_value;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(BilinearField, HasItsValuesAtTheCentres) {
  std::mt19937_64 random(1);
  const BilinearField field(random_field(random, {.resolution = 0.5, .origin = {-3.0, 2.0}, .width = 7, .height = 5}));
  const GridGeometry& geometry = field.nodes().geometry();
  for (std::size_t i = 0; i < geometry.size(); ++i) EXPECT_DOUBLE_EQ(field.at(geometry.center(geometry.cell_of(i))), field.nodes()[i]);
}

TEST(BilinearField, IsTheMeanOfFourInTheMiddleOfThem) {
  const BilinearField field(Grid<double>({.resolution = 2.0, .width = 2, .height = 2}, std::vector<double>{1.0, 2.0, 4.0, 9.0}));
  EXPECT_DOUBLE_EQ(field.at({2.0, 2.0}), 4.0);
  EXPECT_DOUBLE_EQ(field.at({2.0, 1.0}), 1.5);
  EXPECT_DOUBLE_EQ(field.at({1.0, 2.5}), 1.0 + 0.75 * 3.0);
}

TEST(BilinearField, StaysConstantAcrossBeyondTheOutermostCentres) {
  const BilinearField field(Grid<double>({.resolution = 1.0, .width = 2, .height = 2}, std::vector<double>{1.0, 2.0, 4.0, 9.0}));
  for (const double far : {0.5, 0.0, -1.0, -1e6, -1e18}) {
    EXPECT_DOUBLE_EQ(field.at({far, far}), 1.0);
    EXPECT_DOUBLE_EQ(field.at({far, 1.0}), 2.5);
    EXPECT_DOUBLE_EQ(field.at({2.0 - far, far}), 2.0);
    EXPECT_DOUBLE_EQ(field.at({2.0 - far, 2.0 - far}), 9.0);
  }
}

TEST(BilinearField, OfOneCellIsConstant) {
  const BilinearField field(Grid<double>({.resolution = 1.0, .width = 1, .height = 1}, 3.0));
  EXPECT_EQ(field.at({0.1, 0.9}), 3.0);
  EXPECT_EQ(field.at({-7.0, 12.0}), 3.0);
  EXPECT_DOUBLE_EQ(field.integral({-3.0, -4.0}, {3.0, 4.0}), 30.0);
}

TEST(BilinearField, IsContinuousAcrossGridLinesAndCentres) {
  std::mt19937_64 random(2);
  const BilinearField field(random_field(random, {.resolution = 0.3, .origin = {-1.0, -2.0}, .width = 9, .height = 8}));
  std::uniform_real_distribution<double> place(-3.0, 3.0);
  for (int i = -20; i < 20; ++i) {
    const double line = -1.0 + 0.15 * i;
    const double y = place(random);
    EXPECT_NEAR(field.at({std::nextafter(line, -9.0), y}), field.at({std::nextafter(line, 9.0), y}), 1e-12);
    EXPECT_NEAR(field.at({y, std::nextafter(line - 1.0, -9.0)}), field.at({y, std::nextafter(line - 1.0, 9.0)}), 1e-12);
  }
}

TEST(BilinearField, AgreesWithAnIndependentFormula) {
  std::mt19937_64 random(3);
  const BilinearField field(random_field(random, {.resolution = 0.7, .origin = {-4.0, 1.0}, .width = 6, .height = 11}));
  std::uniform_real_distribution<double> place(-6.0, 10.0);
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector2d point(place(random), place(random));
    EXPECT_NEAR(field.at(point), reference_value(field.nodes(), point), 1e-12) << point.transpose();
  }
}

TEST(BilinearField, IsNanInEveryPatchThatHasOneForACorner) {
  Grid<double> nodes({.resolution = 1.0, .width = 4, .height = 4}, 1.0);
  nodes[Cell{0, 0}] = kNaN;
  const BilinearField field(nodes);
  EXPECT_TRUE(std::isnan(field.at({0.5, 0.5})));
  EXPECT_TRUE(std::isnan(field.at({1.4, 1.4})));
  EXPECT_TRUE(std::isnan(field.at({-9.0, -9.0})));
  EXPECT_EQ(field.at({1.6, 1.6}), 1.0);
  EXPECT_TRUE(std::isnan(field.integral({0.5, 0.5}, {3.5, 3.5})));
  EXPECT_DOUBLE_EQ(field.integral({1.6, 1.6}, {3.5, 1.6}), 1.9);
}

TEST(BilinearField, HasNoValueAtNan) {
  const BilinearField field(Grid<double>({.resolution = 1.0, .width = 3, .height = 3}, 1.0));
  EXPECT_TRUE(std::isnan(field.at({kNaN, 0.0})));
  EXPECT_TRUE(std::isnan(field.at({0.0, kNaN})));
  EXPECT_TRUE(std::isnan(field.integral({kNaN, 0.0}, {1.0, 1.0})));
  EXPECT_TRUE(std::isnan(field.integral({0.0, 0.0}, {1.0, kNaN})));
}

struct Segments {
  const char* kind;
  Eigen::Vector2d (*to)(const Eigen::Vector2d& from, std::mt19937_64& random);
};

std::ostream& operator<<(std::ostream& out, const Segments& segments) { return out << segments.kind; }

double uniform(std::mt19937_64& random, double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); }

class IntegralOfABilinearField : public ::testing::TestWithParam<Segments> {
 protected:
  template <typename Check>
  void for_random_segments(Check check) const {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      SCOPED_TRACE(seed);
      std::mt19937_64 random(seed);
      const double resolution = seed % 3 == 0 ? 0.05 : seed % 3 == 1 ? 1.0 : 0.37;
      const GridGeometry geometry{
          .resolution = resolution, .origin = {-2.0 * resolution, -3.0}, .width = 1 + static_cast<int>(random() % 15), .height = 9};
      const BilinearField field(random_field(random, geometry));
      for (int i = 0; i < 25; ++i) {
        Eigen::Vector2d from =
            geometry.origin + Eigen::Vector2d(uniform(random, -0.3, 1.3), uniform(random, -0.3, 1.3)).cwiseProduct(geometry.extent());
        // Half of them begin on a line through centres.
        if (i % 2 == 0) from.y() = geometry.center({0, static_cast<int>(random() % 9)}).y();
        const Eigen::Vector2d to = GetParam().to(from, random);
        SCOPED_TRACE(::testing::Message() << from.transpose() << " to " << to.transpose() << ", resolution " << resolution);
        check(field, from, to, random);
      }
    }
  }
};

TEST_P(IntegralOfABilinearField, AgreesWithGaussLegendreOnPieces) {
  for_random_segments([](const BilinearField& field, const Eigen::Vector2d& from, const Eigen::Vector2d& to, std::mt19937_64&) {
    const double expected = quadrature(field.nodes(), from, to);
    EXPECT_NEAR(field.integral(from, to), expected, 1e-9 * std::max(std::abs(expected), 1e-3));
  });
}

TEST_P(IntegralOfABilinearField, IsTheSameToTheBitInEitherDirection) {
  for_random_segments([](const BilinearField& field, const Eigen::Vector2d& from, const Eigen::Vector2d& to, std::mt19937_64&) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(field.integral(from, to)), std::bit_cast<std::uint64_t>(field.integral(to, from)));
  });
}

TEST_P(IntegralOfABilinearField, AddsUpUnderSplitting) {
  for_random_segments([](const BilinearField& field, const Eigen::Vector2d& from, const Eigen::Vector2d& to, std::mt19937_64& random) {
    const Eigen::Vector2d between = from + uniform(random, 0.0, 1.0) * (to - from);
    const double whole = field.integral(from, to);
    EXPECT_NEAR(field.integral(from, between) + field.integral(between, to), whole, 1e-11 * std::max(1.0, whole));
  });
}

TEST_P(IntegralOfABilinearField, IsMadeOfPiecesThatCoverTheSegmentAndMatchTheField) {
  for_random_segments([](const BilinearField& field, const Eigen::Vector2d& from, const Eigen::Vector2d& to, std::mt19937_64&) {
    double done = 0.0;
    double sum = 0.0;
    field.visit(from, to, [&](double share, const Quadratic& piece) {
      EXPECT_GT(share, 0.0);
      for (const double s : {0.0, 0.25, 0.5, 0.9, 1.0}) EXPECT_NEAR(piece.at(s), field.at(from + (done + s * share) * (to - from)), 1e-10);
      double mean = 0.0;
      for (int k = 0; k < 1000; ++k) mean += piece.at((k + 0.5) / 1000.0) / 1000.0;
      EXPECT_NEAR(piece.mean(), mean, 1e-6);
      done += share;
      sum += share * piece.mean();
    });
    EXPECT_NEAR(done, 1.0, 1e-12);
    EXPECT_NEAR(field.integral(from, to), (to - from).norm() * sum, 1e-11 * std::max(1.0, (to - from).norm()));
  });
}

INSTANTIATE_TEST_SUITE_P(
    Segments, IntegralOfABilinearField,
    ::testing::Values(Segments{"anywhere",
                               [](const Eigen::Vector2d&, std::mt19937_64& random) {
                                 return Eigen::Vector2d(uniform(random, -9, 9), uniform(random, -9, 9));
                               }},
                      Segments{"along x", [](const Eigen::Vector2d& from,
                                             std::mt19937_64& random) { return Eigen::Vector2d(uniform(random, -9, 9), from.y()); }},
                      Segments{"along y", [](const Eigen::Vector2d& from,
                                             std::mt19937_64& random) { return Eigen::Vector2d(from.x(), uniform(random, -9, 9)); }},
                      Segments{"along a diagonal",
                               [](const Eigen::Vector2d& from, std::mt19937_64& random) {
                                 const double way = uniform(random, -9, 9);
                                 return Eigen::Vector2d(from.x() + way, from.y() - way);
                               }},
                      Segments{"of no length", [](const Eigen::Vector2d& from, std::mt19937_64&) { return from; }},
                      Segments{"short",
                               [](const Eigen::Vector2d& from, std::mt19937_64& random) {
                                 return Eigen::Vector2d(from + 1e-3 * Eigen::Vector2d(uniform(random, -1, 1), 1.0));
                               }},
                      Segments{"far beyond", [](const Eigen::Vector2d& from, std::mt19937_64& random) {
                                 return Eigen::Vector2d(from.x() + 1e4, from.y() + uniform(random, -1e4, 1e4));
                               }}));

TEST(IntegralOfABilinearFieldOnALine, OfALinearFieldIsTheValueHalfwayTimesTheLength) {
  Grid<double> nodes({.resolution = 0.5, .origin = {-5.0, -5.0}, .width = 20, .height = 20}, 0.0);
  for (std::size_t i = 0; i < nodes.values().size(); ++i) {
    const Eigen::Vector2d at = nodes.geometry().center(nodes.geometry().cell_of(i));
    nodes[i] = 3.0 + 2.0 * at.x() - at.y();
  }
  const BilinearField field(nodes);
  EXPECT_NEAR(field.integral({-4.0, -3.0}, {2.0, 4.5}), Eigen::Vector2d(6.0, 7.5).norm() * (3.0 + 2.0 * -1.0 - 0.75), 1e-12);
}

TEST(IntegralOfABilinearFieldOnALine, IsLinearInTheField) {
  std::mt19937_64 random(17);
  const GridGeometry geometry{.resolution = 0.4, .origin = {-2.0, -2.0}, .width = 10, .height = 10};
  const Grid<double> a = random_field(random, geometry);
  const Grid<double> b = random_field(random, geometry);
  Grid<double> sum(geometry, 0.0);
  for (std::size_t i = 0; i < geometry.size(); ++i) sum[i] = 3.0 * a[i] - 0.5 * b[i];
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector2d from(uniform(random, -3, 3), uniform(random, -3, 3));
    const Eigen::Vector2d to(uniform(random, -3, 3), uniform(random, -3, 3));
    const double expected = 3.0 * BilinearField(a).integral(from, to) - 0.5 * BilinearField(b).integral(from, to);
    EXPECT_NEAR(BilinearField(sum).integral(from, to), expected, 1e-12);
  }
}

TEST(IntegralOfABilinearFieldOnALine, MissesNoStripHoweverThin) {
  Grid<double> nodes({.resolution = 0.05, .width = 1000, .height = 4}, 0.0);
  for (int y = 0; y < 4; ++y) nodes[Cell{617, y}] = 1.0;
  // One column of centres is a tent of height 1 and a foot of two cells.
  EXPECT_NEAR(BilinearField(nodes).integral({0.0, 0.1}, {50.0, 0.1}), 0.05, 1e-12);
  EXPECT_NEAR(BilinearField(nodes).integral({50.0, 0.03}, {0.0, 0.17}), 0.05 * std::hypot(50.0, 0.14) / 50.0, 1e-12);
}

}  // namespace
}  // namespace alignability
