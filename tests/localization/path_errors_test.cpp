// SPDX-License-Identifier: BSD-3-Clause
#include "localization/path_errors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace alignability {
namespace {

// A metre between scans along x, the estimate beside the truth by so much.
Drive drive_with(const std::vector<double>& errors) {
  Drive drive;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double x = static_cast<double>(i) + 0.5;
    drive.push_back({{static_cast<double>(i), static_cast<double>(i), {x, 2.5, 0.0}}, {{x, 2.5 + errors[i], 0.0}}});
  }
  return drive;
}

// 10 × 5 m, free; a place at y = 2.5 has 0.5 to 2.5 m to the nearest end of the map.
ClearanceMap open_field() { return ClearanceMap(OccupancyMap(Grid<float>({.resolution = 1.0, .width = 10, .height = 5}, 0.0f))); }

PathErrors errors_of(const std::vector<Drive>& runs, double radius = 0.1) { return path_errors({&runs, 1}, 0, open_field(), radius, {}); }

TEST(PathErrors, AreThoseOfHandWorkedRuns) {
  const PathErrors errors = errors_of({drive_with({0.0, 0.1, 0.2}), drive_with({0.0, 0.3, 0.6})});
  EXPECT_NEAR(errors.mean.value, 0.2, 1e-12);
  EXPECT_NEAR(errors.max.value, 0.6, 1e-12);
  EXPECT_NEAR(errors.goal.value, 0.4, 1e-12);
  EXPECT_NEAR(errors.lost.value, 0.5, 1e-12) << "one of two was off by more than half a metre";
  EXPECT_NEAR(errors.p95.value, 0.3 + 0.75 * 0.3, 1e-12)
      << "of six errors the 95th percentile is three quarters from the fifth to the sixth";
}

TEST(PathErrors, AreUnsafeWhereTheyExceedWhatTheRobotHasLeft) {
  // The clearance is 0.5 m at x = 0.5 and 1.5 m at x = 1.5; a robot of 0.4 m leaves 0.1 and 1.1 m.
  EXPECT_NEAR(errors_of({drive_with({0.11, 1.0})}, 0.4).unsafe.value, 0.5, 1e-12);
  EXPECT_NEAR(errors_of({drive_with({0.09, 1.0})}, 0.4).unsafe.value, 0.0, 1e-12);
}

TEST(PathErrors, SpreadOverRunsNotOverScans) {
  const std::vector<double> calm(500, 0.1), wild(500, 0.5);
  const PathErrors alike = errors_of({drive_with(calm), drive_with(calm), drive_with(calm)});
  EXPECT_NEAR(alike.mean.low, 0.1, 1e-12);
  EXPECT_NEAR(alike.mean.high, 0.1, 1e-12);
  const PathErrors mixed = errors_of({drive_with(calm), drive_with(calm), drive_with(wild)});
  EXPECT_NEAR(mixed.mean.low, 0.1, 1e-12);
  EXPECT_NEAR(mixed.mean.high, 0.5, 1e-12) << "three runs may as well all have been wild";
}

TEST(PathErrors, OfNoRunsAreNotNumbers) { EXPECT_TRUE(std::isnan(errors_of({}).p95.value)); }

TEST(ErrorsAlong, ArePutInStepsOfArcLength) {
  const std::vector<Drive> runs{drive_with({0.0, 0.1, 0.2, 0.4}), drive_with({0.0, 0.3, 0.2, 0.6})};
  const auto along = errors_along(runs, 0, 1.0);
  ASSERT_EQ(along.size(), 4u);
  EXPECT_EQ(along[1].s, 1.0);
  EXPECT_NEAR(along[1].mean, 0.2, 1e-12);
  EXPECT_NEAR(along[3].mean, 0.5, 1e-12);
  EXPECT_NEAR(along[3].p95, 0.4 + 0.95 * 0.2, 1e-12);
  EXPECT_THROW(errors_along(runs, 0, 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace alignability
