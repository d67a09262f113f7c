// SPDX-License-Identifier: BSD-3-Clause
#include "localization/odometry.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace alignability {
namespace {

TEST(Odometry, ReportsTheTruthWithoutErrors) {
  Odometry odometry({}, 1);
  EXPECT_EQ(odometry.report({0.3, 0.1, 0.2}), (Pose2{0.3, 0.1, 0.2}));
}

TEST(Odometry, IsBiasedInProportionToTheWay) {
  Odometry odometry({.scale_bias = 0.02, .heading_bias = 0.01}, 1);
  const Pose2 report = odometry.report({2.0, 0.0, 0.0});
  EXPECT_NEAR(report.x, 2.04, 1e-12);
  EXPECT_NEAR(report.yaw, 0.02, 1e-12);
  EXPECT_EQ(odometry.report({0.0, 0.0, 1.0}).yaw, 1.0);
}

// However many steps the way is cut into.
TEST(Odometry, WandersWithTheRootOfTheWay) {
  for (const int steps : {1, 16}) {
    double xx = 0.0, yaw2 = 0.0;
    constexpr int kRuns = 4000;
    for (std::uint64_t run = 0; run < kRuns; ++run) {
      Odometry odometry({.position_noise = 0.03, .heading_noise = 0.02}, run);
      double x = 0.0, yaw = 0.0;
      for (int step = 0; step < steps; ++step) {
        const Pose2 report = odometry.report({4.0 / steps, 0.0, 0.0});
        x += report.x - 4.0 / steps;
        yaw += report.yaw;
      }
      xx += x * x;
      yaw2 += yaw * yaw;
    }
    EXPECT_NEAR(std::sqrt(xx / kRuns), 0.06, 0.003);
    EXPECT_NEAR(std::sqrt(yaw2 / kRuns), 0.04, 0.002);
  }
}

TEST(Odometry, ErrsAlikeWithTheSameSeed) {
  const OdometryError error{.position_noise = 0.1, .heading_noise = 0.1, .turning_noise = 0.1};
  const auto report = [&](std::uint64_t seed) { return Odometry(error, seed).report({1.0, 0.0, 0.5}); };
  EXPECT_EQ(report(1), report(1));
  EXPECT_NE(report(1), report(2));
}

TEST(Odometry, RefusesNoiseBelowZeroAndBiasesThatAreNotFinite) {
  EXPECT_THROW(Odometry({.position_noise = -0.1}, 1), std::invalid_argument);
  EXPECT_THROW(Odometry({.turning_noise = std::nan("")}, 1), std::invalid_argument);
  EXPECT_THROW(Odometry({.scale_bias = std::nan("")}, 1), std::invalid_argument);
  EXPECT_THROW(Odometry({.heading_bias = std::nan("")}, 1), std::invalid_argument);
}

}  // namespace
}  // namespace alignability
