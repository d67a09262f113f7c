// SPDX-License-Identifier: BSD-3-Clause
#include "planner/nurbs.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <random>
#include <unsupported/Eigen/Splines>

#include "core/segment.hpp"

namespace alignability {
namespace {

constexpr double kTolerance = 1e-3;

// Eigen's splines, of which a rational one is the shadow.
class Oracle {
 public:
  explicit Oracle(const Nurbs& curve) : spline_(knots(curve), points(curve)) {}

  Eigen::Vector2d at(double parameter) const { return Eigen::Vector3d(spline_(parameter)).hnormalized(); }

 private:
  using Spline = Eigen::Spline<double, 3>;

  static Spline::KnotVectorType knots(const Nurbs& curve) {
    return Eigen::Map<const Spline::KnotVectorType>(curve.knots.data(), 1, static_cast<Eigen::Index>(curve.knots.size()));
  }
  static Spline::ControlPointVectorType points(const Nurbs& curve) {
    Spline::ControlPointVectorType points(3, curve.points.size());
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
      points.col(static_cast<Eigen::Index>(i)) = curve.points[i].weight * curve.points[i].at.homogeneous();
    }
    return points;
  }

  Spline spline_;
};

double distance_to_path(const Eigen::Vector2d& point, const std::vector<Pose2>& path) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    least = std::min(least, distance_to_segment(point, path[i].position(), path[i + 1].position()));
  }
  return least;
}

Nurbs random_curve(std::mt19937_64& engine, bool clamped) {
  std::uniform_real_distribution<double> place(-20.0, 20.0), weight(0.2, 5.0), share(0.0, 1.0);
  Nurbs curve;
  curve.degree = std::uniform_int_distribution<int>(1, 5)(engine);
  const auto degree = static_cast<std::size_t>(curve.degree);
  const std::size_t points = degree + 1 + std::uniform_int_distribution<std::size_t>(0, 5)(engine);
  for (std::size_t i = 0; i < points; ++i) curve.points.push_back({{place(engine), place(engine)}, weight(engine)});
  for (std::size_t i = 0; i < points + degree + 1; ++i) curve.knots.push_back(share(engine));
  std::ranges::sort(curve.knots);
  for (std::size_t i = 0; clamped && i <= degree; ++i) {
    curve.knots[i] = 0.0;
    curve.knots[points + i] = 1.0;
  }
  return curve;
}

class RandomCurves : public testing::TestWithParam<bool> {};

TEST_P(RandomCurves, StayWithinTheToleranceOfTheirStraightLines) {
  constexpr int kSamples = 400;
  std::mt19937_64 engine(5);
  for (int trial = 0; trial < 60; ++trial) {
    SCOPED_TRACE(trial);
    const Nurbs curve = random_curve(engine, GetParam());
    ASSERT_EQ(fault_of_nurbs(curve), std::nullopt);
    const Oracle oracle(curve);
    const std::vector<Pose2> path = flattened(curve, kTolerance);
    std::vector<Pose2> samples;
    for (auto span = static_cast<std::size_t>(curve.degree); span < curve.points.size(); ++span) {
      for (int i = 0; i <= kSamples; ++i) {
        const Eigen::Vector2d at = oracle.at(std::lerp(curve.knots[span], curve.knots[span + 1], static_cast<double>(i) / kSamples));
        samples.push_back({at.x(), at.y(), 0.0});
        EXPECT_LE(distance_to_path(at, path), kTolerance + 1e-9);
      }
    }
    EXPECT_LE((path.front().position() - samples.front().position()).norm(), 1e-9);
    EXPECT_LE((path.back().position() - samples.back().position()).norm(), 1e-9);
    for (const Pose2& pose : path) EXPECT_LE(distance_to_path(pose.position(), samples), 0.01);
  }
}

INSTANTIATE_TEST_SUITE_P(ClampedAndNot, RandomCurves, testing::Bool());

TEST(Nurbs, DrawACircleExactly) {
  const double corner = std::sqrt(0.5);
  const Nurbs quarter{.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{{2, 0}, 1}, {{2, 2}, corner}, {{0, 2}, 1}}};
  const std::vector<Pose2> path = flattened(quarter, kTolerance);
  EXPECT_GT(path.size(), 8u);
  EXPECT_LT(path.size(), 100u);
  for (const Pose2& pose : path) {
    EXPECT_NEAR(pose.position().norm(), 2.0, 1e-12);
    EXPECT_NEAR(normalized_angle(pose.yaw - std::atan2(pose.y, pose.x)), std::numbers::pi / 2.0, 1e-9);
  }
}

// The example of LIF 2.0, about a half circle.
TEST(Nurbs, RunOffAndArriveAlongTheirControlPoints) {
  const Nurbs curve{.degree = 2, .knots = {0, 0, 0, 0.5, 1, 1, 1}, .points = {{{5, 0}, 1}, {{5, 5}, 1}, {{15, 5}, 1}, {{15, 0}, 1}}};
  const std::vector<Pose2> path = flattened(curve, kTolerance);
  EXPECT_EQ(path.front(), (Pose2{5, 0, std::numbers::pi / 2.0}));
  EXPECT_EQ(path.back(), (Pose2{15, 0, -std::numbers::pi / 2.0}));
  EXPECT_EQ(std::ranges::count(path, (Pose2{10, 5, 0})), 1);
}

TEST(Nurbs, OfDegreeOneAreTheirControlPointsAndTurnAtThem) {
  const Nurbs bent{.degree = 1, .knots = {0, 0, 0.5, 1, 1}, .points = {{{1, 1}, 1}, {{4, 1}, 3}, {{4, 5}, 1}}};
  const double up = std::numbers::pi / 2.0;
  EXPECT_EQ(flattened(bent, kTolerance), (std::vector<Pose2>{{1, 1, 0}, {4, 1, 0}, {4, 1, up}, {4, 5, up}}));
}

TEST(Nurbs, OfOnePlaceHaveNoPoses) {
  const Nurbs point{.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{{1, 1}, 1}, {{1, 1}, 1}, {{1, 1}, 1}}};
  EXPECT_TRUE(flattened(point, kTolerance).empty());
}

TEST(Nurbs, WithRepeatedControlPointsHaveTheHeadingOfTheOthers) {
  const Nurbs curve{.degree = 3, .knots = {0, 0, 0, 0, 1, 1, 1, 1}, .points = {{{0, 0}, 1}, {{0, 0}, 1}, {{3, 3}, 1}, {{3, 3}, 1}}};
  for (const Pose2& pose : flattened(curve, kTolerance)) EXPECT_NEAR(pose.yaw, std::numbers::pi / 4.0, 1e-12);
}

TEST(Nurbs, EndEvenWithTheWeightsThatAreFurthestApart) {
  const Nurbs curve{.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{{0, 0}, 1e-6}, {{9e8, 1}, 1e6}, {{0, 2}, 1e-6}}};
  EXPECT_LT(flattened(curve, 1.0).size(), 1000u);
}

TEST(Nurbs, AreRefusedWithTheReason) {
  const Nurbs good{.degree = 2, .knots = {0, 0, 0, 0.5, 1, 1, 1}, .points = {{{0, 0}, 1}, {{1, 1}, 1}, {{2, 1}, 1}, {{3, 0}, 1}}};
  ASSERT_EQ(fault_of_nurbs(good), std::nullopt);
  const auto fault = [&](auto&& change) {
    Nurbs curve = good;
    change(curve);
    return fault_of_nurbs(curve).value_or("no fault");
  };
  EXPECT_EQ(fault([](Nurbs& c) { c.degree = 0; }), "its degree must be from 1 to 32");
  EXPECT_EQ(fault([](Nurbs& c) { c.degree = 33; }), "its degree must be from 1 to 32");
  EXPECT_EQ(fault([](Nurbs& c) { c.degree = 4; }), "a degree of 4 takes at least 5 control points");
  EXPECT_EQ(fault([](Nurbs& c) { c.knots.pop_back(); }), "4 control points of degree 2 take 7 knots, not 6");
  EXPECT_EQ(fault([](Nurbs& c) { c.knots[3] = -0.5; }), "no knot may be less than the one before");
  EXPECT_EQ(fault([](Nurbs& c) { c.knots[3] = std::nan(""); }), "its knots must be from -1e+09 to 1e+09");
  EXPECT_EQ(fault([](Nurbs& c) { c.knots.assign(7, 0.5); }), "its knots leave it no length");
  EXPECT_EQ(fault([](Nurbs& c) { c.points[1].weight = 0.0; }), "its weights must be from 1e-06 to 1e+06");
  EXPECT_EQ(fault([](Nurbs& c) { c.points[1].at.x() = 1e300; }), "its control points' coordinates must be from -1e+09 to 1e+09");
  EXPECT_EQ(fault([](Nurbs& c) {
              c.points.assign(6, {{0, 0}, 1});
              c.knots = {0, 0, 0, 0.5, 0.5, 0.5, 1, 1, 1};
            }),
            "a knot within it may be repeated no more than 2 times");
}

}  // namespace
}  // namespace alignability
