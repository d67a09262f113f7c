// SPDX-License-Identifier: BSD-3-Clause
#include "localization/regularization.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace alignability {
namespace {

TEST(EffectiveNumber, CountsParticlesOfEqualWeightAndNoneWithoutAny) {
  const std::array<double, 5> logs{-1000.0, -1000.0, -1000.0, -std::numeric_limits<double>::infinity(), -1000.0 + std::log(1e-200)};
  const std::vector<double> weights = normalized_weights(logs);
  EXPECT_DOUBLE_EQ(weights[0], 1.0 / 3.0);
  EXPECT_EQ(weights[3], 0.0);
  EXPECT_DOUBLE_EQ(effective_number(weights), 3.0);
}

// One of two particles is worth q of the other, hence (1 + q)²/(1 + q²) are effective: 1.8 for q = ½.
TEST(PowerThatKeeps, IsThatOfTheHandComputedCase) {
  const std::array<double, 2> even{0.0, 0.0}, likelihoods{0.0, -300.0};
  EXPECT_NEAR(power_that_keeps(1.8, even, likelihoods), std::log(2.0) / 300.0, 1e-11);
}

TEST(PowerThatKeeps, IsOneWhereTheLikelihoodsKeepEnough) {
  const std::array<double, 2> even{0.0, 0.0}, likelihoods{0.0, std::log(0.6)};
  EXPECT_EQ(power_that_keeps(1.8, even, likelihoods), 1.0);
}

TEST(PowerThatKeeps, LeavesAsManyOfParticlesThatWeighedUnlike) {
  std::vector<double> logs, likelihoods;
  for (int i = 0; i < 100; ++i) {
    logs.push_back(0.3 * std::sin(i));
    likelihoods.push_back(-0.5 * i * i);
  }
  const double power = power_that_keeps(30.0, logs, likelihoods);
  for (std::size_t i = 0; i < logs.size(); ++i) logs[i] += power * likelihoods[i];
  EXPECT_NEAR(effective_number(normalized_weights(logs)), 30.0, 1e-6);
}

TEST(OptimalBandwidth, IsAHalfForAHundredParticlesAndFallsByTheSeventhRoot) {
  EXPECT_NEAR(optimal_bandwidth(100), std::pow(0.008, 1.0 / 7.0), 1e-15);
  EXPECT_NEAR(optimal_bandwidth(100), 0.5, 0.002);
  EXPECT_NEAR(optimal_bandwidth(128 * 100) / optimal_bandwidth(100), 0.5, 1e-12);
}

// Yaws on either side of π.
constexpr std::array kThree{Particle{{1.0, 2.0, radians(179)}, 0.25}, Particle{{3.0, 2.0, radians(-179)}, 0.25},
                            Particle{{2.0, 5.0, radians(180)}, 0.5}};

TEST(MeanOf, WeighsAndTakesYawsAsDirections) {
  const Pose2 mean = mean_of(kThree);
  EXPECT_DOUBLE_EQ(mean.x, 2.0);
  EXPECT_DOUBLE_EQ(mean.y, 3.5);
  EXPECT_NEAR(normalized_angle(mean.yaw - radians(180)), 0.0, 1e-12);
}

TEST(CovarianceRoot, SquaresToTheWeightedCovariance) {
  const Eigen::Matrix3d root = covariance_root(kThree);
  Eigen::Matrix3d expected;
  const double turned = radians(1);
  expected << 0.5, 0.0, 0.5 * turned, 0.0, 2.25, 0.0, 0.5 * turned, 0.0, 0.5 * turned * turned;
  EXPECT_TRUE((root * root.transpose()).isApprox(expected, 1e-12));
  const std::array one{Particle{{1.0, 2.0, 3.0}, 1.0}};
  EXPECT_LT(covariance_root(one).norm(), 1e-7) << "of one particle";
}

}  // namespace
}  // namespace alignability
