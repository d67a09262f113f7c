// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "alignability/log_map.hpp"
#include "core/distribution.hpp"
#include "core/rank_correlation.hpp"
#include "tests/alignability/simulated.hpp"
#include "tests/shared_data.hpp"

namespace alignability {
namespace {

using test::box;

// A hall of 30 × 20 m. Its walls are higher than the 8 m that are told of it: returns reach 8.13 m, and none is from a ceiling.
Scene hall() {
  constexpr double kHeight = 12.0;
  return Scene({box({0.0, 0.0, -1.0}, {30.0, 20.0, 0.0}), box({-1.0, 0.0, 0.0}, {0.0, 20.0, kHeight}),
                box({30.0, 0.0, 0.0}, {31.0, 20.0, kHeight}), box({0.0, -1.0, 0.0}, {30.0, 0.0, kHeight}),
                box({0.0, 20.0, 0.0}, {30.0, 21.0, kHeight})});
}

// As the scans show it: 16 rings at atan(sin(-15° + k·1.875°)), 1800 columns all around, no noise.
LidarModel hall_lidar() {
  LidarModel lidar;
  for (int ring = 0; ring < 16; ++ring) lidar.elevations.push_back(std::atan(std::sin(radians(-15.0 + 1.875 * ring))));
  lidar.sectors = {{.min = radians(-180), .max = radians(180), .columns = 1800}};
  lidar.range_min = 0.1;
  lidar.range_max = 100.0;
  return lidar;
}

// In the order of no lidar, as the logged scans are.
Scan unordered(Scan scan) {
  scan.columns *= scan.rings;
  scan.rings = 1;
  return scan;
}

TEST(SimulatedHall, LoggedAlphaIsThatOfScansSimulatedInTheSameHall) {
  ALIGNABILITY_REQUIRE_SHARED_DATA(folder, "logs/simulated-hall");
  const ScanLog log = read_scan_log(folder / "scans", read_trajectory(folder / "poses_all_101.txt"), {});
  const std::vector<ScoredPlace> logged = score_log(log.scans, {});
  const Scene scene = hall();
  Scorer scorer({});
  std::vector<double> alpha_logged, alpha_simulated, differences;
  for (std::size_t i = 0; i < logged.size(); ++i) {
    const Scan scan = unordered(simulate_scan(scene, hall_lidar(), log.scans[i].T_map_lidar));
    alpha_logged.push_back(logged[i].score.alpha);
    alpha_simulated.push_back(scorer.alignability(scan).alpha);
    differences.push_back(std::abs(alpha_logged[i] - alpha_simulated[i]));
    std::cout << log.scans[i].file.filename().string() << ": logged " << alpha_logged[i] << ", simulated " << alpha_simulated[i] << '\n';
  }
  const Distribution apart = distribution_of(differences);
  std::cout << "apart: median " << apart.median << ", 95 % " << apart.p95 << ", max " << apart.max << "; rank correlation "
            << rank_correlation(alpha_logged, alpha_simulated) << '\n';
  ASSERT_EQ(differences.size(), 26u);
  EXPECT_LT(apart.max, 1e-3);
  EXPECT_GT(rank_correlation(alpha_logged, alpha_simulated), 0.999);
}

}  // namespace
}  // namespace alignability
