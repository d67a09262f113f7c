// SPDX-License-Identifier: BSD-3-Clause
#include "localization/scan_matcher.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "lidar/thinning.hpp"

namespace alignability {
namespace {

constexpr Pose2 kExactly{0.0, 0.0, 0.0};

// Points of the plane y = `y`, every so far along x and up.
std::vector<Eigen::Vector3f> wall_along_x(float from, float to, float y, float spacing) {
  std::vector<Eigen::Vector3f> points;
  for (int column = 0; from + spacing * static_cast<float>(column) <= to; ++column) {
    for (int row = 0; spacing * static_cast<float>(row) <= 3.0f; ++row) {
      points.emplace_back(from + spacing * static_cast<float>(column), y, spacing * static_cast<float>(row));
    }
  }
  return points;
}

std::vector<Eigen::Vector3f> wall_along_y(float from, float to, float x, float spacing) {
  std::vector<Eigen::Vector3f> points = wall_along_x(from, to, x, spacing);
  for (Eigen::Vector3f& point : points) std::swap(point.x(), point.y());
  return points;
}

std::vector<Eigen::Vector3f> both(std::vector<Eigen::Vector3f> one, const std::vector<Eigen::Vector3f>& other) {
  one.insert(one.end(), other.begin(), other.end());
  return one;
}

// A wall 2 m to the left of the map's origin, and what is seen of it from there.
std::shared_ptr<const PlaneMap> wall_map() {
  return std::make_shared<const PlaneMap>(wall_along_x(-20.0f, 20.0f, 2.0f, 0.05f), PlaneMapOptions{});
}
std::vector<Eigen::Vector3f> wall_scan() { return wall_along_x(-5.0f, 5.0f, 2.0f, 0.1f); }

ScanMatcherOptions without_outliers() {
  ScanMatcherOptions options;
  options.outlier = 1e9;
  return options;
}

// Points of a single direction and one unknown: a prior variance P and n points of variance σ², of which a share counts, give
// P / (1 + P·n·share/σ²), and as much less of the offset.
TEST(ScanMatcher, WeighsPredictionAndScanByHandComputedVariances) {
  const ScanMatcherOptions options = without_outliers();
  ScanMatcher matcher(wall_map(), {0.0, 0.01, 0.0}, {0.0, 0.002, 0.0}, options);
  std::vector<Eigen::Vector3f> scan = wall_scan();
  matcher.see(scan);
  std::erase_if(scan, [&](const Eigen::Vector3f& point) { return point.z() < options.least_height; });
  const auto count = static_cast<double>(thinned(scan, options.thinning).size());
  const double prior = 0.002 * 0.002;
  const double left = 1.0 / (1.0 + prior * count * options.independent_share / (options.deviation * options.deviation));
  EXPECT_GT(left, 0.2);
  EXPECT_LT(left, 0.8);
  EXPECT_NEAR(matcher.estimate().y, 0.01 * left, 1e-6);
  EXPECT_NEAR(matcher.covariance()(1, 1), prior * left, 1e-12);
  EXPECT_EQ(matcher.estimate().x, 0.0);
  EXPECT_EQ(matcher.estimate().yaw, 0.0);
}

TEST(ScanMatcher, CorrectsAcrossOneWallAndNotAlong) {
  ScanMatcher matcher(wall_map(), {0.3, 0.25, 0.03}, {0.1, 0.3, 0.05}, {});
  matcher.see(wall_scan());
  EXPECT_NEAR(matcher.estimate().y, 0.0, 1e-3);
  EXPECT_NEAR(matcher.estimate().yaw, 0.0, 1e-3);
  EXPECT_NEAR(matcher.estimate().x, 0.3, 1e-6);
  EXPECT_NEAR(matcher.covariance()(0, 0), 0.01, 1e-9);
  EXPECT_LT(matcher.covariance()(1, 1), 0.01 * 0.01);
}

TEST(ScanMatcher, IsLessSureAlongOneWallByTheMotionNoise) {
  ScanMatcher matcher(wall_map(), {0.0, 0.0, 0.0}, {0.1, 0.02, 0.01}, {});
  double variance = 0.1 * 0.1;
  double across = 1.0;
  for (int step = 0; step < 10; ++step) {
    matcher.move({0.5, 0.0, 0.0});
    matcher.see(wall_scan());
    variance += 0.025 * 0.025;
    EXPECT_NEAR(matcher.covariance()(0, 0), variance, 1e-9);
    EXPECT_LE(matcher.covariance()(1, 1), across);
    across = 0.01 * 0.01;
  }
  EXPECT_NEAR(matcher.estimate().x, 5.0, 1e-6);
}

TEST(ScanMatcher, CorrectsBothWaysInACorner) {
  const auto map = std::make_shared<const PlaneMap>(both(wall_along_x(-10.0f, 3.0f, 2.0f, 0.05f), wall_along_y(-10.0f, 2.0f, 3.0f, 0.05f)),
                                                    PlaneMapOptions{});
  ScanMatcher matcher(map, {0.25, -0.3, radians(-2)}, {0.3, 0.3, radians(2)}, {});
  matcher.see(both(wall_along_x(-5.0f, 3.0f, 2.0f, 0.1f), wall_along_y(-5.0f, 2.0f, 3.0f, 0.1f)));
  EXPECT_NEAR(matcher.estimate().x, 0.0, 0.005);
  EXPECT_NEAR(matcher.estimate().y, 0.0, 0.005);
  EXPECT_NEAR(matcher.estimate().yaw, 0.0, 0.002);
  EXPECT_LT(matcher.covariance()(0, 0), 0.01 * 0.01);
  EXPECT_LT(matcher.covariance()(1, 1), 0.01 * 0.01);
}

// F·P·Fᵀ + G·Q·Gᵀ of a turn left and a metre ahead of it.
TEST(ScanMatcher, PredictsAloneWhereNothingIsSeen) {
  ScanMatcher matcher(wall_map(), {1.0, 2.0, radians(90)}, {0.1, 0.2, 0.03}, {});
  matcher.move({1.0, 0.0, 0.2});
  matcher.see({});
  matcher.see(std::vector<Eigen::Vector3f>{{100.0f, 0.0f, 1.0f}, {0.0f, 0.0f, 0.0f}});
  EXPECT_NEAR(matcher.estimate().x, 1.0, 1e-12);
  EXPECT_NEAR(matcher.estimate().y, 3.0, 1e-12);
  EXPECT_NEAR(matcher.estimate().yaw, radians(90) + 0.2, 1e-12);
  const double ahead = 0.05 + 0.1 * 0.2, aside = 0.05 + 0.01 * 0.2, turned = 0.01 + 0.1 * 0.2;
  const Eigen::Matrix3d covariance = matcher.covariance();
  EXPECT_NEAR(covariance(0, 0), 0.01 + 0.03 * 0.03 + aside * aside, 1e-12) << "ahead is along y";
  EXPECT_NEAR(covariance(1, 1), 0.04 + ahead * ahead, 1e-12);
  EXPECT_NEAR(covariance(2, 2), 0.03 * 0.03 + turned * turned, 1e-12);
  EXPECT_NEAR(covariance(0, 2), -0.03 * 0.03, 1e-12) << "turned left it has gone less far along x";
}

// Three tenths of what is seen, in the middle, is 0.3 m nearer than the map has it. Cauchy's weight of that is 1 / (1 + (0.3 / 0.048)²) =
// 0.025, which leaves 0.3 · 0.025 · 3 / 7 = 3.2 mm.
TEST(ScanMatcher, IsHardlyLedAstrayByWhatWasMoved) {
  ScanMatcher matcher(wall_map(), {0.0, 0.0, 0.0}, {0.05, 0.05, 0.02}, {});
  const std::vector<Eigen::Vector3f> wall = both(wall_along_x(-5.0f, -1.6f, 2.0f, 0.1f), wall_along_x(1.6f, 5.0f, 2.0f, 0.1f));
  const std::vector<Eigen::Vector3f> scan = both(wall, wall_along_x(-1.5f, 1.5f, 1.7f, 0.1f));
  for (int step = 0; step < 20; ++step) {
    matcher.move({0.02, 0.0, 0.0});
    matcher.see(scan);
  }
  EXPECT_NEAR(matcher.estimate().y, 0.0032, 0.0008);
  ScanMatcher gullible(wall_map(), {0.0, 0.0, 0.0}, {0.05, 0.05, 0.02}, without_outliers());
  gullible.see(scan);
  EXPECT_GT(std::abs(gullible.estimate().y), 0.03);
}

TEST(ScanMatcher, StaysWhereItKnowsExactlyToBe) {
  ScanMatcher matcher(wall_map(), {0.0, 0.1, 0.0}, kExactly, {});
  matcher.see(wall_scan());
  EXPECT_EQ(matcher.estimate(), (Pose2{0.0, 0.1, 0.0}));
  EXPECT_TRUE(matcher.covariance().isZero());
}

TEST(ScanMatcher, StaysFiniteAndSureToADegreeWhateverItSees) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInfinity = std::numeric_limits<float>::infinity();
  const std::vector<Eigen::Vector3f> strange{{kNan, 0.0f, 1.0f}, {0.0f, kInfinity, 1.0f}, {1e30f, -1e30f, 1e30f}, {0.0f, 0.0f, kNan}};
  const auto elsewhere = std::make_shared<const PlaneMap>(wall_along_y(-10.0f, 10.0f, 2.3f, 0.05f), PlaneMapOptions{});
  const auto nothing = std::make_shared<const PlaneMap>(std::vector<Eigen::Vector3f>{}, PlaneMapOptions{});
  for (const auto& map : {elsewhere, nothing}) {
    ScanMatcher matcher(map, {0.0, 0.0, 0.0}, {10.0, 10.0, 3.0}, {});
    for (int step = 0; step < 50; ++step) {
      matcher.move({0.5, 0.1, 0.3});
      matcher.see(strange);
      matcher.see(wall_scan());
      const Pose2 pose = matcher.estimate();
      ASSERT_TRUE(pose.position().allFinite() && std::isfinite(pose.yaw));
      ASSERT_TRUE(matcher.covariance().allFinite());
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matcher.covariance());
      ASSERT_GT(solver.eigenvalues()[0], -1e-9 * solver.eigenvalues()[2]);
    }
  }
}

TEST(ScanMatcher, RefusesOptionsOutOfRange) {
  const auto matcher = [](const Pose2& deviations, const ScanMatcherOptions& options) { ScanMatcher(wall_map(), {}, deviations, options); };
  EXPECT_THROW(matcher({-0.1, 0.0, 0.0}, {}), std::invalid_argument);
  EXPECT_THROW(matcher({}, {.thinning = 0.0}), std::invalid_argument);
  EXPECT_THROW(matcher({}, {.deviation = 0.0}), std::invalid_argument);
  EXPECT_THROW(matcher({}, {.independent_share = 1.5}), std::invalid_argument);
  EXPECT_THROW(matcher({}, {.independent_share = 0.0}), std::invalid_argument);
  EXPECT_THROW(matcher({}, {.least_height = std::nan("")}), std::invalid_argument);
  EXPECT_THROW(matcher({}, {.outlier = -1.0}), std::invalid_argument);
  EXPECT_THROW(matcher({}, {.iterations = 0}), std::invalid_argument);
}

}  // namespace
}  // namespace alignability
