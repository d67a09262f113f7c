// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/joined_scans.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lidar/scan_file.hpp"
#include "tests/core/temporary_folder.hpp"
#include "tests/core/thrown_message.hpp"
#include "tests/shared_data.hpp"

namespace alignability {
namespace {

class JoinedScans : public testing::Test {
 protected:
  PosedScan scan(const std::string& name, const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3d& at) const {
    write_pcd({.points = points, .rings = 1, .columns = static_cast<int>(points.size())}, folder / name);
    PosedScan posed{.file = folder / name};
    posed.T_map_lidar.translation() = at;
    return posed;
  }

  test::TemporaryFolder folder;
};

TEST_F(JoinedScans, StandInTheMapWhereTheirPosesPutThem) {
  PosedScan turned = scan("2.pcd", {{1.0f, 0.0f, 0.0f}}, {5.0, 0.0, 0.0});
  turned.T_map_lidar.rotate(Eigen::AngleAxisd(0.5 * M_PI, Eigen::Vector3d::UnitZ()));
  const std::vector<PosedScan> scans{scan("1.pcd", {{1.0f, 2.0f, 3.0f}}, {10.0, 0.0, 1.0}), turned};
  const auto cloud = joined(scans, {});
  ASSERT_EQ(cloud.size(), 2u);
  EXPECT_TRUE(cloud[0].isApprox(Eigen::Vector3f(11.0f, 2.0f, 4.0f)));
  EXPECT_TRUE(cloud[1].isApprox(Eigen::Vector3f(5.0f, 1.0f, 0.0f), 1e-6f));
}

TEST_F(JoinedScans, LeaveOutWhatIsTooNearTooFarOrNone) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<PosedScan> scans{
      scan("1.pcd", {{0.0f, 0.0f, 0.0f}, {0.4f, 0.0f, 0.0f}, {0.6f, 0.0f, 0.0f}, {9.0f, 0.0f, 0.0f}, {nan, nan, nan}}, {0.0, 0.0, 0.0})};
  EXPECT_EQ(joined(scans, {}).size(), 2u);
  EXPECT_EQ(joined(scans, {.range_max = 5.0}).size(), 1u);
}

TEST_F(JoinedScans, LeaveAPointACubeWhereAVoxelIsGiven) {
  std::vector<PosedScan> scans;
  for (int i = 0; i < 10; ++i) {
    scans.push_back(
        scan(std::to_string(i) + ".pcd", {{2.01f, 0.01f, 0.01f}, {2.03f, 0.01f, 0.01f}, {3.01f, 0.01f, 0.01f}}, {0.0, 0.0, 0.0}));
  }
  const auto cloud = joined(scans, {.thinning = 0.1});
  ASSERT_EQ(cloud.size(), 2u);
  EXPECT_NEAR(cloud[0].x(), 2.02f, 1e-3f);
  EXPECT_NEAR(cloud[1].x(), 3.01f, 1e-3f);
}

TEST_F(JoinedScans, AreRefusedFarFromTheOrigin) {
  const std::vector<PosedScan> scans{scan("1.pcd", {{1.0f, 0.0f, 0.0f}}, {512000.0, 5403000.0, 0.0})};
  EXPECT_THAT(test::thrown_message([&] { joined(scans, {}); }), testing::HasSubstr("1.pcd: was taken 5427205 m from the origin of map"));
}

TEST_F(JoinedScans, TellHowManyAreJoined) {
  const std::vector<PosedScan> scans{scan("1.pcd", {{1.0f, 0.0f, 0.0f}}, {0.0, 0.0, 0.0}),
                                     scan("2.pcd", {{1.0f, 0.0f, 0.0f}}, {1.0, 0.0, 0.0})};
  std::vector<std::size_t> done;
  joined(scans, {.progress = [&](const Progress& progress) { done.push_back(progress.done); }});
  EXPECT_THAT(done, testing::ElementsAre(0, 1, 2));
}

TEST_F(JoinedScans, StopWhenAsked) {
  const std::vector<PosedScan> scans{scan("1.pcd", {{1.0f, 0.0f, 0.0f}}, {0.0, 0.0, 0.0})};
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW(joined(scans, {.stop = stop.get_token()}), Interrupted);
}

// The truth of this log is a box: walls at x = 0 and 30, y = 0 and 20, the floor at z = 0. Its poses are written with six digits.
TEST(JoinedLog, OfASimulatedHallIsTheHall) {
  ALIGNABILITY_REQUIRE_SHARED_DATA(hall, "logs/simulated-hall");
  const ScanLog log = read_scan_log(hall / "scans", read_trajectory(hall / "poses_all_101.txt"), {});
  const auto cloud = joined(log.scans, {});
  ASSERT_EQ(cloud.size(), 26u * 28800u);
  float worst = 0.0f;
  for (const Eigen::Vector3f& p : cloud) {
    worst =
        std::max(worst, std::min({std::abs(p.x()), std::abs(p.x() - 30.0f), std::abs(p.y()), std::abs(p.y() - 20.0f), std::abs(p.z())}));
  }
  EXPECT_LT(worst, 1e-3f) << "the farthest that a point lies from the walls and the floor [m]";
}

}  // namespace
}  // namespace alignability
