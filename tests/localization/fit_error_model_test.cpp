// SPDX-License-Identifier: BSD-3-Clause
#include "localization/fit_error_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace alignability {
namespace {

const ErrorModel kTruth{.growth = 0.02, .recovery = 3.0, .least = 0.03, .alpha_poor = 0.1, .alpha_rich = 0.4, .calibration = {}};

// 60 × 1 m: rich, then blind, rich again, in between, rich.
RiskField risk_along() {
  const GridGeometry cells{.resolution = 1.0, .width = 60, .height = 1};
  Grid<float> alpha(cells, 0.6f);
  for (int x = 10; x < 25; ++x) alpha[Cell{x, 0}] = 0.02f;
  for (int x = 38; x < 48; ++x) alpha[Cell{x, 0}] = x < 43 ? 0.2f : 0.3f;
  return {AlignabilityMap{.geometry = cells, .layers = {{"alpha", alpha}}, .options = {}, .sensor = {}, .provenance = {}},
          OccupancyMap(Grid<float>({.resolution = 1.0, .width = 60, .height = 1}, 0.0f)),
          {}};
}

// One drive whose error is what a model says of the way.
DrivenPath driven_by(const ErrorModel& model, const RiskField& risk, double from, double to) {
  DrivenPath path{"path", {{from, 0.5, 0.0}, {to, 0.5, 0.0}}, {Drive{}}};
  double error = 0.1;
  for (double x = from; x <= to; x += 0.1) {
    path.runs.front().push_back({{x - from, x - from, {x, 0.5, 0.0}}, {{x + error, 0.5, 0.0}}});
    error = model.advanced(error, risk.alpha(x + 0.05, 0.5, 0.0), 0.1);
  }
  return path;
}

ErrorModel fitted_to(const std::vector<DrivenPath>& paths, const RiskField& risk) {
  return fit_error_model(std::vector<SitePaths>{{paths, risk}}, 0);
}

TEST(FitErrorModel, FindsTheModelThatMadeTheErrors) {
  const RiskField risk = risk_along();
  const DrivenPath path = driven_by(kTruth, risk, 1.0, 59.0);
  const ErrorModel fitted = fitted_to({path}, risk);
  EXPECT_NEAR(fitted.growth, kTruth.growth, 0.1 * kTruth.growth);
  EXPECT_NEAR(fitted.recovery, kTruth.recovery, 0.25 * kTruth.recovery);
  EXPECT_NEAR(fitted.least, kTruth.least, 0.01);
  EXPECT_EQ(fitted.alpha_poor, kTruth.alpha_poor);
  EXPECT_EQ(fitted.alpha_rich, kTruth.alpha_rich);
  const auto check = check_error_model(fitted, path, 0, risk);
  ASSERT_TRUE(check.has_value());
  EXPECT_LT(check->rms, 0.01);
}

TEST(FitErrorModel, IsRefusedWhereTheDrivesTellNothingOfGrowthOrOfRecovery) {
  const RiskField risk = risk_along();
  const DrivenPath rich = driven_by(kTruth, risk, 49.0, 59.0), blind = driven_by(kTruth, risk, 12.0, 23.0);
  EXPECT_THROW(fitted_to({rich}, risk), std::invalid_argument);
  EXPECT_THROW(fitted_to({blind}, risk), std::invalid_argument);
  EXPECT_NO_THROW(fitted_to({rich, blind}, risk));
}

TEST(FitErrorModel, FitsSeveralSitesAtOnce) {
  const RiskField risk = risk_along(), elsewhere = risk_along();
  const std::vector<DrivenPath> rich{driven_by(kTruth, risk, 26.0, 59.0)}, blind{driven_by(kTruth, risk, 1.0, 23.0)};
  const std::vector<SitePaths> sites{{rich, risk}, {blind, elsewhere}};
  EXPECT_NEAR(fit_error_model(sites, 0).growth, kTruth.growth, 0.1 * kTruth.growth);
}

TEST(CheckErrorModel, CoversNothingWhereTheErrorIsTwiceWhatIsPredicted) {
  const RiskField risk = risk_along();
  ErrorModel slower = kTruth;
  slower.growth = 0.0;
  const DrivenPath path = driven_by(kTruth, risk, 8.0, 24.0);
  const auto check = check_error_model(slower, path, 0, risk);
  ASSERT_TRUE(check.has_value());
  EXPECT_LT(check->covered, 0.2);
  EXPECT_GT(check->rms, 0.1);
  EXPECT_FALSE(check_error_model(kTruth, driven_by(kTruth, risk, 1.0, 2.5), 0, risk).has_value());
}

}  // namespace
}  // namespace alignability
