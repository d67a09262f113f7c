// SPDX-License-Identifier: BSD-3-Clause
#include "localization/ndt_mcl.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <array>
#include <cmath>
#include <random>
#include <stdexcept>

namespace alignability {
namespace {

constexpr Pose2 kExactly{0.0, 0.0, 0.0};

std::vector<Eigen::Vector3f> cloud_about(const Eigen::Vector3f& center, std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  std::normal_distribution<float> normal(0.0f, 0.03f);
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < 50; ++i) points.emplace_back(center + Eigen::Vector3f(normal(engine), 0.3f * normal(engine), normal(engine)));
  return points;
}

TEST(MatchScore, IsOneAtTheMeanAndATenthFarAway) {
  EXPECT_EQ(match_score(0.0), 1.0);
  EXPECT_NEAR(match_score(40.0), 0.1 + 0.9 * std::exp(-1.0), 1e-15);
  EXPECT_EQ(match_score(std::numeric_limits<double>::infinity()), 0.1);
}

TEST(Moved, GoesInThePosesOwnFrame) {
  const Pose2 pose = moved({1.0, 2.0, radians(90)}, {3.0, 1.0, radians(100)});
  EXPECT_NEAR(pose.x, 0.0, 1e-12);
  EXPECT_NEAR(pose.y, 5.0, 1e-12);
  EXPECT_NEAR(pose.yaw, radians(-170), 1e-12);
}

// Two cells seen, turned by 90 degrees, each of which the map has where x is right to within the cell, and not elsewhere: both, one or
// none.
TEST(NdtMcl, WeighsParticlesByHandComputedScores) {
  const std::array centers{Eigen::Vector3f(2.2f, 0.2f, 1.0f), Eigen::Vector3f(3.08f, 0.2f, 1.0f)};
  std::vector<Eigen::Vector3f> known, seen;
  for (std::uint64_t i = 0; i < 2; ++i) {
    for (const Eigen::Vector3f& point : cloud_about(centers[i], 1 + i)) known.push_back(point);
    for (const Eigen::Vector3f& point : cloud_about(centers[i], 3 + i)) seen.emplace_back(point.y(), -point.x(), point.z());
  }
  const auto map = std::make_shared<const Ndt>(known, NdtOptions{.cell = 0.4});
  const Ndt scan(seen, {.cell = 0.4});
  ASSERT_EQ(map->cells().size(), 2u);
  ASSERT_EQ(scan.cells().size(), 2u);
  const Eigen::Matrix3d R = Eigen::AngleAxisd(radians(90), Eigen::Vector3d::UnitZ()).toRotationMatrix();
  constexpr std::array kBegin{2.0, 2.8};  // of the cells along x
  for (const CellCombination combination : {CellCombination::sum, CellCombination::product}) {
    NdtMcl mcl(map, {0.0, 0.0, radians(90)}, {0.2, 0.0, 0.0}, {.particles = 200, .combination = combination, .resample_below = 0.0}, 2);
    mcl.see(scan);
    std::vector<double> expected;
    std::array<int, 3> matched{};
    for (const Particle& particle : mcl.particles()) {
      double sum = 1.0, product = 1.0;
      std::size_t matches = 0;
      for (const NdtCell& cell : scan.cells()) {
        const Eigen::Vector3d mean = R * cell.mean + Eigen::Vector3d(particle.pose.x, 0.0, 0.0);
        double score = 0.0;
        for (std::size_t i = 0; i < 2; ++i) {
          if (mean.x() < kBegin[i] || mean.x() >= kBegin[i] + 0.4) continue;
          const Eigen::Vector3d apart = mean - map->cells()[i].mean;
          const Eigen::Matrix3d both = map->cells()[i].covariance + R * cell.covariance * R.transpose();
          score = 0.1 + 0.9 * std::exp(-0.025 * apart.dot(both.inverse() * apart));
          ++matches;
        }
        sum += score;
        product *= score > 0.0 ? score : 0.1;
      }
      ++matched[matches];
      expected.push_back(combination == CellCombination::sum ? sum : product);
    }
    for (const int count : matched) EXPECT_GT(count, 10);
    double total = 0.0;
    for (const double weight : expected) total += weight;
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(mcl.particles()[i].weight, expected[i] / total, 1e-12);
  }
}

TEST(NdtMcl, FollowsOdometryToTheLetterWithoutNoise) {
  const auto map = std::make_shared<const Ndt>(std::vector<Eigen::Vector3f>{}, NdtOptions{});
  NdtMclOptions options;
  options.noise = {.per_metre = kExactly, .per_radian = kExactly};
  NdtMcl mcl(map, {1.0, 1.0, 0.0}, kExactly, options, 1);
  Pose2 truth{1.0, 1.0, 0.0};
  for (int step = 0; step < 50; ++step) {
    mcl.move({0.1, 0.0, 0.05});
    truth = moved(truth, {0.1, 0.0, 0.05});
  }
  EXPECT_NEAR(mcl.estimate().x, truth.x, 1e-9);
  EXPECT_NEAR(mcl.estimate().y, truth.y, 1e-9);
  EXPECT_NEAR(normalized_angle(mcl.estimate().yaw - truth.yaw), 0.0, 1e-9);
}

TEST(NdtMcl, SpreadsWithTheWayAsTheMotionNoiseSays) {
  const auto map = std::make_shared<const Ndt>(std::vector<Eigen::Vector3f>{}, NdtOptions{});
  NdtMclOptions options{.particles = 20000};
  options.noise = {.per_metre = {0.05, 0.02, 0.0}, .per_radian = kExactly};
  NdtMcl mcl(map, {}, kExactly, options, 3);
  mcl.move({2.0, 0.0, 0.0});
  double xx = 0.0, yy = 0.0;
  for (const Particle& particle : mcl.particles()) {
    xx += particle.weight * (particle.pose.x - 2.0) * (particle.pose.x - 2.0);
    yy += particle.weight * particle.pose.y * particle.pose.y;
  }
  EXPECT_NEAR(std::sqrt(xx), 0.1, 0.003);
  EXPECT_NEAR(std::sqrt(yy), 0.04, 0.0012);
}

TEST(NdtMcl, SurvivesAScanOrAMapWithNothingInIt) {
  const auto nothing = std::make_shared<const Ndt>(std::vector<Eigen::Vector3f>{}, NdtOptions{});
  NdtMcl mcl(nothing, {}, {0.1, 0.1, 0.1}, {.combination = CellCombination::product}, 1);
  for (int round = 0; round < 30; ++round) {
    mcl.see(Ndt(cloud_about({2.2f, 0.2f, 1.0f}, 1), {}));
    mcl.see(*nothing);
  }
  EXPECT_TRUE(std::isfinite(mcl.estimate().x));
  double sum = 0.0;
  for (const Particle& particle : mcl.particles()) sum += particle.weight;
  EXPECT_NEAR(sum, 1.0, 1e-9);
}

TEST(NdtMcl, RefusesToBeWithoutParticles) {
  const auto map = std::make_shared<const Ndt>(std::vector<Eigen::Vector3f>{}, NdtOptions{});
  EXPECT_THROW(NdtMcl(map, {}, {}, {.particles = 0}, 1), std::invalid_argument);
  EXPECT_THROW(NdtMcl(map, {}, {}, {.resample_after = 0}, 1), std::invalid_argument);
}

// Drawn anew once, by weights all alike: what they were drawn from tells how far each was scattered.
TEST(NdtMcl, ScattersWhatItDrawsByAKernelOfTheBandwidthAskedForAndKeepsTheirCovariance) {
  const auto nothing = std::make_shared<const Ndt>(std::vector<Eigen::Vector3f>{}, NdtOptions{});
  constexpr int kParticles = 20000;
  const Pose2 deviations{0.3, 0.1, 0.02};
  NdtMclOptions options{.particles = kParticles, .resample_after = 1};
  options.regularization = {.bandwidths = 0.5};
  NdtMcl mcl(nothing, {1.0, 2.0, 3.0}, deviations, options, 1);
  const std::vector<Particle> before(mcl.particles().begin(), mcl.particles().end());
  mcl.see(*nothing);
  const double width = 0.5 * optimal_bandwidth(kParticles);
  const Pose2 mean = mean_of(before);
  Eigen::Vector3d squares = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < before.size(); ++i) {
    const Pose2 &from = before[i].pose, &to = mcl.particles()[i].pose;
    const Eigen::Vector3d was(from.x - mean.x, from.y - mean.y, normalized_angle(from.yaw - mean.yaw));
    const Eigen::Vector3d is(to.x - mean.x, to.y - mean.y, normalized_angle(to.yaw - mean.yaw));
    squares += (is - std::sqrt(1.0 - width * width) * was).cwiseAbs2() / kParticles;
  }
  EXPECT_NEAR(std::sqrt(squares.x()) / (width * deviations.x), 1.0, 0.03);
  EXPECT_NEAR(std::sqrt(squares.y()) / (width * deviations.y), 1.0, 0.03);
  EXPECT_NEAR(std::sqrt(squares.z()) / (width * deviations.yaw), 1.0, 0.03);
  const Eigen::Matrix3d was = covariance_root(before), is = covariance_root(mcl.particles());
  EXPECT_TRUE((is * is.transpose()).isApprox(was * was.transpose(), 0.03));
}

TEST(NdtMcl, RefusesARegularizationThatNoScanCouldSatisfy) {
  const auto map = std::make_shared<const Ndt>(std::vector<Eigen::Vector3f>{}, NdtOptions{});
  const auto with = [&](const Regularization& regularization) { return NdtMcl(map, {}, {}, {.regularization = regularization}, 1); };
  EXPECT_NO_THROW(with({.least_effective = 0.49}));
  EXPECT_THROW(with({.least_effective = 0.5}), std::invalid_argument);
  EXPECT_THROW(with({.least_effective = 0.0}), std::invalid_argument);
  EXPECT_THROW(with({.bandwidths = -0.1}), std::invalid_argument);
  EXPECT_THROW(with({.bandwidths = 1.1}), std::invalid_argument);
}

}  // namespace
}  // namespace alignability
