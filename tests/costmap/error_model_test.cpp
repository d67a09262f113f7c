// SPDX-License-Identifier: BSD-3-Clause
#include "costmap/error_model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace alignability {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

ErrorModel model() { return {.growth = 0.02, .recovery = 3.0, .least = 0.01, .alpha_poor = 0.1, .alpha_rich = 0.4, .calibration = {}}; }

TEST(ErrorModel, GrowsEvenlyWhereTheRobotIsBlindOrNobodyKnows) {
  EXPECT_NEAR(model().advanced(0.05, 0.02, 10.0), 0.05 + 0.2, 1e-12);
  EXPECT_NEAR(model().advanced(0.05, kUnknown, 10.0), 0.05 + 0.2, 1e-12);
}

TEST(ErrorModel, ShrinksToTheLeastWhereAlphaIsRich) {
  EXPECT_NEAR(model().advanced(0.5, 0.9, 3.0), 0.01 + 0.49 / std::exp(1.0), 1e-12);
  EXPECT_NEAR(model().advanced(0.5, 0.9, 1000.0), 0.01, 1e-12);
  EXPECT_EQ(model().advanced(0.0, 0.9, 1.0), 0.01) << "nothing is better than the least";
}

// Against small steps of the differential equation, and the same in one step as in two.
TEST(ErrorModel, IsTheSolutionOfItsEquation) {
  for (const double alpha : {0.0, 0.15, 0.25, 0.399, 0.5}) {
    double error = 0.2;
    const double poor = model().poverty(alpha);
    constexpr int kSteps = 100'000;
    for (int i = 0; i < kSteps; ++i) error += 5.0 / kSteps * (0.02 * poor - (error - 0.01) * (1.0 - poor) / 3.0);
    EXPECT_NEAR(model().advanced(0.2, alpha, 5.0), error, 1e-5) << alpha;
    EXPECT_NEAR(model().advanced(model().advanced(0.2, alpha, 2.0), alpha, 3.0), model().advanced(0.2, alpha, 5.0), 1e-12);
  }
}

TEST(ErrorModel, IsMonotoneInAlphaAndInTheErrorBefore) {
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (int i = 0; i < 2000; ++i) {
    const double low = share(engine), high = low + (1.0 - low) * share(engine);
    const double error = 0.01 + share(engine), metres = 5.0 * share(engine);
    EXPECT_GE(model().advanced(error, low, metres), model().advanced(error, high, metres) - 1e-12);
    EXPECT_LE(model().advanced(error, low, metres), model().advanced(error + 0.1, low, metres));
  }
}

TEST(Mismatches, AreSaidOneByOne) {
  const Calibration fitted{.localizer = "ndt_mcl_sum", .sensor = "HDL", .noise = 0.008, .range_max = 6.5, .scale_bias = 0.02};
  EXPECT_TRUE(mismatches(fitted, fitted).empty());
  Calibration used = fitted;
  used.noise = 0.02;
  used.range_max.reset();
  const auto sentences = mismatches(fitted, used);
  ASSERT_EQ(sentences.size(), 2u);
  EXPECT_EQ(sentences[0], "fitted for range noise 0.008 m, used for 0.02 m");
  EXPECT_EQ(sentences[1], "fitted for range 6.5 m, used for in full");
}

}  // namespace
}  // namespace alignability
