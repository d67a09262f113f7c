// SPDX-License-Identifier: BSD-3-Clause
#include "localization/cell_errors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace alignability {
namespace {

const GridGeometry kCells{.resolution = 1.0, .width = 50, .height = 1};

// Two scans in each cell along x, half a metre apart, the estimate ahead of the truth by error(s).
template <typename Error>
Drive drive_along(Error error) {
  Drive drive;
  for (int i = 0; i < 100; ++i) {
    const double s = 0.5 * i;
    const double x = s + 0.25;
    drive.push_back({{s, s, {x, 0.5, 0.0}}, {{x + error(s), 0.5, 0.0}}});
  }
  return drive;
}

TEST(CellErrors, AreTheMeanOverScansAndTheirGrowthOverMetres) {
  const std::vector<Drive> runs{drive_along([](double s) { return 0.01 * s; })};
  const auto errors = cell_errors({&runs, 1}, 0, kCells, 0.0);
  ASSERT_EQ(errors.size(), 50u);
  EXPECT_EQ(errors[3].cell, (Cell{3, 0}));
  EXPECT_NEAR(errors[3].error, 0.01 * 3.25, 1e-12);
  EXPECT_NEAR(errors[3].growth, 0.01, 1e-9);
  EXPECT_NEAR(errors[3].metres, 1.0, 1e-12);
}

TEST(CellErrors, CountEachRunOnceHoweverManyScansItHasInACell) {
  Drive slow = drive_along([](double) { return 0.4; });
  const Drive twice = slow;
  for (const DriveSample& sample : twice) slow.push_back(sample);
  const std::vector<Drive> runs{slow, drive_along([](double) { return 0.1; })};
  EXPECT_NEAR(cell_errors({&runs, 1}, 0, kCells, 0.0)[7].error, 0.25, 1e-12);
}

TEST(CellErrors, LeaveOutTheFirstMetres) {
  const std::vector<Drive> runs{drive_along([](double) { return 0.1; })};
  EXPECT_EQ(cell_errors({&runs, 1}, 0, kCells, 2.0).front().cell, (Cell{2, 0}));
}

// Poor in the first half and rich in the second.
Grid<float> half_poor() {
  Grid<float> reading(kCells, 0.02f);
  for (int x = 0; x < 50; ++x) reading[Cell{x, 0}] = (x < 25 ? 0.0f : 0.5f) + 0.001f * static_cast<float>(x);
  return reading;
}

TEST(Prediction, OfErrorsThatGrowWhereTheReadingIsPoorAndShrinkWhereItIsRich) {
  const auto error = [](double s) { return s < 25.0 ? 0.02 * s : 0.5 * std::exp(-(s - 25.0)); };
  const Prediction told =
      prediction(std::vector<std::vector<Drive>>{{drive_along(error), drive_along(error)}}, 0, half_poor(), 0.0, {.resamples = 50});
  EXPECT_LT(told.growth.value, -0.3);
  EXPECT_EQ(told.growth.low, told.growth.high) << "both runs are the same";
  EXPECT_EQ(told.large_only_where_poor.verdict(), Statement::Verdict::fails) << "it takes a metre of rich ground to find back";
  EXPECT_EQ(told.large_only_where_poor.exceptions, 1u);
  EXPECT_EQ(told.large_only_where_poor.cells, 25u);
  EXPECT_EQ(told.small_where_rich.verdict(), Statement::Verdict::fails);
}

TEST(Prediction, OfAnErrorThatIsTheReadingUpsideDownIsMinusOne) {
  const auto error = [](double s) { return 0.3 - 0.004 * std::floor(s + 0.25); };
  Grid<float> reading(kCells, 0.0f);
  for (int x = 0; x < 50; ++x) reading[Cell{x, 0}] = 0.015f * static_cast<float>(x);
  const Prediction told = prediction(std::vector<std::vector<Drive>>{{drive_along(error)}}, 0, reading, 0.0, {.resamples = 10});
  EXPECT_NEAR(told.error.value, -1.0, 1e-12);
  EXPECT_EQ(told.large_only_where_poor.verdict(), Statement::Verdict::untested) << "too few cells are poor";
}

TEST(Prediction, PassesOverCellsWithoutAReading) {
  Grid<float> reading = half_poor();
  reading[Cell{30, 0}] = std::numeric_limits<float>::quiet_NaN();
  const Prediction told =
      prediction(std::vector<std::vector<Drive>>{{drive_along([](double) { return 0.0; })}}, 0, reading, 0.0, {.resamples = 10});
  EXPECT_EQ(told.small_where_rich.cells, 24u);
  EXPECT_EQ(told.small_where_rich.verdict(), Statement::Verdict::holds);
  EXPECT_TRUE(std::isnan(told.error.value)) << "all errors are equal";
}

}  // namespace
}  // namespace alignability
