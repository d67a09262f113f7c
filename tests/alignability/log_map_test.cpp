// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/log_map.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/distribution.hpp"
#include "lidar/scan_file.hpp"
#include "tests/alignability/coarse_lidar.hpp"
#include "tests/alignability/simulated.hpp"
#include "tests/core/temporary_folder.hpp"
#include "tests/core/thrown_message.hpp"

namespace alignability {
namespace {

using test::box;

Scene room() {
  return Scene({box({0.0, 0.0, -0.1}, {6.0, 4.0, 0.0}), box({-0.2, 0.0, 0.0}, {0.0, 4.0, 3.0}), box({6.0, 0.0, 0.0}, {6.2, 4.0, 3.0}),
                box({0.0, -0.2, 0.0}, {6.0, 0.0, 3.0}), box({0.0, 4.0, 0.0}, {6.0, 4.2, 3.0})});
}

// Scans of a room, each from a place of its own and a metre up.
class LogOfARoom : public testing::Test {
 protected:
  PosedScan taken_at(double x, double y, double yaw) {
    Eigen::Isometry3d pose(Eigen::Translation3d(x, y, 1.0) * Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()));
    PosedScan posed{.file = folder / (std::to_string(count_) + ".pcd"), .stamp = 0.0, .T_map_lidar = pose};
    write_pcd(simulate_scan(room(), test::coarse_lidar(), pose, {}, NoiseKey{1, 0, count_++}), posed.file);
    return posed;
  }
  std::vector<PosedScan> few_scans() {
    return {taken_at(1.2, 1.2, 0.0), taken_at(1.5, 1.5, 1.0), taken_at(1.8, 1.4, 2.0), taken_at(4.5, 2.5, 0.3)};
  }
  static LogMapOptions options() {
    LogMapOptions options;
    options.alignability.segmentation.range_min = 0.1;
    return options;
  }

  test::TemporaryFolder folder;
  std::uint64_t count_ = 0;
};

TEST_F(LogOfARoom, HasTheMedianOfItsScansInTheCellTheyWereTakenIn) {
  const std::vector<PosedScan> scans = few_scans();
  const std::vector<ScoredPlace> places = score_log(scans, options());
  const AlignabilityMap map = map_of(places, geometry_around(places, 1.0), options());
  EXPECT_EQ(map.geometry, (GridGeometry{.resolution = 1.0, .origin = {0.0, 0.0}, .width = 6, .height = 4}));
  std::vector<double> alphas;
  for (std::size_t i = 0; i < 3; ++i) alphas.push_back(score(read_scan_file(scans[i].file), options().alignability).alignability.alpha);
  std::ranges::sort(alphas);
  EXPECT_EQ((map.alpha()[Cell{1, 1}]), static_cast<float>(alphas[1]));
  EXPECT_EQ(((*map.find_layer("samples"))[Cell{1, 1}]), 3.0f);
  EXPECT_EQ(((*map.find_layer("iqr"))[Cell{1, 1}]), static_cast<float>(quantile(alphas, 0.75) - quantile(alphas, 0.25)));
  EXPECT_EQ(((*map.find_layer("samples"))[Cell{4, 2}]), 1.0f);
  EXPECT_GT((map.alpha()[Cell{4, 2}]), 0.0f);
  for (const AlignabilityMap::Layer& layer : map.layers) {
    EXPECT_EQ(std::ranges::count_if(layer.values.values(), [](float value) { return !std::isnan(value); }), 2) << layer.name;
  }
}

TEST_F(LogOfARoom, IsTheSameForAnyNumberOfThreads) {
  const std::vector<PosedScan> scans = few_scans();
  const auto bits_with = [&](int threads) {
    LogMapOptions with = options();
    with.threads = threads;
    with.alignability.readings = {Reading::robust, Reading::information};
    const std::vector<ScoredPlace> places = score_log(scans, with);
    std::vector<std::uint32_t> bits;
    for (const AlignabilityMap::Layer& layer : map_of(places, geometry_around(places, 1.0), with).layers) {
      for (const float value : layer.values.values()) bits.push_back(std::bit_cast<std::uint32_t>(value));
    }
    return bits;
  };
  EXPECT_EQ(bits_with(1), bits_with(3));
}

// A corridor's weakest direction is along it, wherever the lidar looks.
TEST_F(LogOfARoom, TurnsWeakestDirectionsIntoTheMap) {
  const Scene corridor(test::plain_corridor());
  std::vector<PosedScan> scans;
  for (const double yaw : {0.0, 0.7, 1.9}) {
    Eigen::Isometry3d pose(Eigen::Translation3d(0.5, 0.1, 1.9) * Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()));
    PosedScan posed{.file = folder / ("c" + std::to_string(scans.size()) + ".pcd"), .stamp = 0.0, .T_map_lidar = pose};
    write_pcd(simulate_scan(corridor, test::hdl32e(), pose, {.range_max = 6.5}, NoiseKey{1, 0, scans.size()}), posed.file);
    scans.push_back(posed);
  }
  LogMapOptions with = options();
  with.alignability.readings = {Reading::information};
  const std::vector<ScoredPlace> places = score_log(scans, with);
  const AlignabilityMap map = map_of(places, geometry_around(places, 1.0), with);
  const Cell cell{1, 1};
  EXPECT_NEAR(std::abs((*map.find_layer("weak_x"))[cell]), 1.0f, 0.02f);
  EXPECT_NEAR(std::abs((*map.find_layer("information_x"))[cell]), 1.0f, 0.02f);
}

TEST_F(LogOfARoom, PutsAScanInTheCellOfTheRobotNotOfItsLidar) {
  LogMapOptions with = options();
  with.alignability.T_base_scan.translation() = Eigen::Vector3d(0.7, 0.0, 1.0);
  const std::vector<PosedScan> scans{taken_at(2.5, 1.5, 0.0)};
  const std::vector<ScoredPlace> places = score_log(scans, with);
  EXPECT_TRUE(places.front().T_map_base.translation().isApprox(Eigen::Vector3d(1.8, 1.5, 0.0)));
}

TEST_F(LogOfARoom, PassesOverPlacesOffTheGrid) {
  const std::vector<ScoredPlace> places = score_log(few_scans(), options());
  const GridGeometry small{.resolution = 1.0, .origin = {4.0, 2.0}, .width = 1, .height = 1};
  EXPECT_EQ(((*map_of(places, small, options()).find_layer("samples"))[Cell{0, 0}]), 1.0f);
}

TEST_F(LogOfARoom, LeavesOutWhatIsBeyondTheRange) {
  const std::vector<PosedScan> scans = few_scans();
  LogMapOptions near = options();
  near.range_max = 1.5;
  EXPECT_LT(score_log(scans, near).front().score.points, score_log(scans, options()).front().score.points);
  near.range_max = -1.0;
  EXPECT_THROW(score_log(scans, near), std::invalid_argument);
}

TEST_F(LogOfARoom, NamesTheScanThatCannotBeRead) {
  std::vector<PosedScan> scans = few_scans();
  folder.write("2.pcd", "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 9\nHEIGHT 1\nPOINTS 9\nDATA binary\ncut");
  EXPECT_THAT(test::thrown_message([&] { score_log(scans, options()); }), testing::HasSubstr("2.pcd: ends early"));
}

TEST_F(LogOfARoom, StopsWhenAsked) {
  LogMapOptions with = options();
  std::stop_source stop;
  stop.request_stop();
  with.stop = stop.get_token();
  EXPECT_THROW(score_log(few_scans(), with), Interrupted);
}

TEST(LogGrid, IsRefusedWhereItWouldBeTooLarge) {
  std::vector<ScoredPlace> places(2);
  places[1].T_map_base.translation() = Eigen::Vector3d(1e6, 1e6, 0.0);
  EXPECT_THROW(geometry_around(places, 1.0), std::invalid_argument);
  EXPECT_THROW(geometry_around({}, 1.0), std::invalid_argument);
  EXPECT_THROW(geometry_around(places, 0.0), std::invalid_argument);
  EXPECT_EQ(geometry_around(places, 1000.0).width, 1003);
}

}  // namespace
}  // namespace alignability
