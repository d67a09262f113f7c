// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/scan_log.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/core/temporary_folder.hpp"
#include "tests/core/thrown_message.hpp"
#include "tests/shared_data.hpp"

namespace alignability {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> names_of(const std::vector<PosedScan>& scans) {
  std::vector<std::string> names;
  for (const PosedScan& scan : scans) names.push_back(scan.file.filename().string());
  return names;
}

std::vector<double> x_of(const std::vector<PosedScan>& scans) {
  std::vector<double> values;
  for (const PosedScan& scan : scans) values.push_back(scan.T_map_lidar.translation().x());
  return values;
}

class ScanLogs : public testing::Test {
 protected:
  void make(std::initializer_list<const char*> names) const {
    for (const char* name : names) folder.write(name, "");
  }
  ScanLog read(const std::string& trajectory, const ScanLogOptions& options = {}) const {
    return read_scan_log(folder / "", parse_trajectory(trajectory, "poses.txt"), options);
  }
  std::string refusal(const std::string& trajectory, const ScanLogOptions& options = {}) const {
    return test::thrown_message([&] { read(trajectory, options); });
  }

  test::TemporaryFolder folder;
};

const std::string kOneAndTwo = "1 10 0 0 0 0 0 1\n2 20 0 0 0 0 0 1\n";

TEST_F(ScanLogs, FindPosesByTheStampInAScansName) {
  make({"scan_2.pcd", "scan_1.000000.PLY", "notes.txt", "1.5.bin"});
  const ScanLog log = read(kOneAndTwo, {.max_gap = 0.5});
  EXPECT_EQ(log.pairing, Pairing::stamp);
  EXPECT_THAT(names_of(log.scans), ElementsAre("1.5.bin", "scan_1.000000.PLY", "scan_2.pcd"));
  EXPECT_THAT(x_of(log.scans), ElementsAre(15.0, 10.0, 20.0));
}

TEST_F(ScanLogs, TurnAndMoveEvenlyBetweenTwoPoses) {
  make({"1.25.pcd"});
  const ScanLog log = read("1 0 0 0 0 0 0 1\n2 4 0 0 0 0 0.70711 0.70711\n", {.max_gap = 0.25});
  const Eigen::Isometry3d& pose = log.scans.front().T_map_lidar;
  EXPECT_NEAR(pose.translation().x(), 1.0, 1e-12);
  EXPECT_NEAR(std::atan2(pose.linear()(1, 0), pose.linear()(0, 0)), 0.125 * M_PI, 1e-9);
}

TEST_F(ScanLogs, LeaveOutScansThatNoPoseIsNearTo) {
  make({"0.8.pcd", "0.95.pcd", "1.5.pcd", "2.05.pcd", "2.2.pcd"});
  const ScanLog log = read(kOneAndTwo, {.max_gap = 0.1});
  EXPECT_THAT(names_of(log.scans), ElementsAre("0.95.pcd", "2.05.pcd"));
  EXPECT_THAT(x_of(log.scans), ElementsAre(10.0, 20.0));
  EXPECT_EQ(log.without_a_pose.size(), 3u);
}

TEST_F(ScanLogs, TellSecondsFromMillisecondsMicrosecondsAndNanoseconds) {
  make({"1630577758.569490.pcd", "1630577759569.pcd", "1630577760569490.pcd", "1630577761569490000.pcd"});
  std::string trajectory;
  for (int second = 8; second < 12; ++second) {
    trajectory += std::to_string(1630577750 + second) + ".5694900 " + std::to_string(second) + " 0 0 0 0 0 1\n";
  }
  const ScanLog log = read(trajectory, {.max_gap = 0.001});
  ASSERT_EQ(log.scans.size(), 4u);
  for (const PosedScan& scan : log.scans) {
    const double second = std::round(scan.stamp - 0.56949) - 1630577750.0;
    EXPECT_NEAR(scan.T_map_lidar.translation().x(), second, 1e-3) << scan.file;
  }
}

TEST_F(ScanLogs, FindPosesByNumber) {
  make({"full006.pcd", "full012.pcd", "full009.pcd"});
  const ScanLog log = read("6 1.5 1 0 0 0 0 0 1\n12 3.5 3 0 0 0 0 0 1\n");
  EXPECT_EQ(log.pairing, Pairing::number);
  EXPECT_THAT(names_of(log.scans), ElementsAre("full006.pcd", "full012.pcd"));
  EXPECT_THAT(x_of(log.scans), ElementsAre(1.0, 3.0));
  EXPECT_EQ(log.scans[1].stamp, 3.5);
  ASSERT_EQ(log.without_a_pose.size(), 1u);
  EXPECT_EQ(log.without_a_pose.front().filename(), "full009.pcd");
}

TEST_F(ScanLogs, NumberTheLinesOfAKittiTrajectoryFromNought) {
  make({"000001.bin"});
  const ScanLog log = read("1 0 0 5 0 1 0 0 0 0 1 0\n1 0 0 6 0 1 0 0 0 0 1 0\n", {.pairing = Pairing::number});
  EXPECT_THAT(x_of(log.scans), ElementsAre(6.0));
}

TEST_F(ScanLogs, PairByOrderAsPeopleCount) {
  make({"scan10.pcd", "scan9.pcd", "scan009b.pcd"});
  const ScanLog log = read("1 0 0 1 0 1 0 0 0 0 1 0\n1 0 0 2 0 1 0 0 0 0 1 0\n1 0 0 3 0 1 0 0 0 0 1 0\n");
  EXPECT_EQ(log.pairing, Pairing::order);
  EXPECT_THAT(names_of(log.scans), ElementsAre("scan9.pcd", "scan009b.pcd", "scan10.pcd"));
  EXPECT_THAT(x_of(log.scans), ElementsAre(1.0, 2.0, 3.0));
}

TEST_F(ScanLogs, PutTheLidarOnTheRobotWherePosesAreTheRobots) {
  make({"1.pcd"});
  ScanLogOptions options{.frame = TrajectoryFrame::base_link};
  options.T_base_lidar.translation() = Eigen::Vector3d(0.5, 0.0, 1.9);
  const ScanLog log = read("1 10 20 0 0 0 0.70711 0.70711\n", options);
  EXPECT_TRUE(log.scans.front().T_map_lidar.translation().isApprox(Eigen::Vector3d(10.0, 20.5, 1.9), 1e-9));
}

TEST_F(ScanLogs, AreOrderedAsPeopleCountEvenWhereNamesBeginAlike) {
  make({"a10.pcd", "a9.pcd", "a09.pcd", "a.pcd", "a9b.pcd"});
  std::filesystem::create_directory(folder / "a1.pcd");
  const ScanLog log =
      read("1 0 0 0 0 0 0 1\n2 0 0 0 0 0 0 1\n3 0 0 0 0 0 0 1\n4 0 0 0 0 0 0 1\n5 0 0 0 0 0 0 1\n", {.pairing = Pairing::order});
  EXPECT_THAT(names_of(log.scans), ElementsAre("a.pcd", "a09.pcd", "a9.pcd", "a9b.pcd", "a10.pcd")) << "a folder is no scan";
}

TEST_F(ScanLogs, NeedWholeNumbersToBePairedByNumber) {
  make({"scan_1.5.pcd"});
  EXPECT_THAT(refusal("6 1.5 1 0 0 0 0 0 1\n"), HasSubstr("has 1.5 in its name, where the number of a pose is a whole one"));
}

TEST_F(ScanLogs, SayWhyThereIsNoPairing) {
  EXPECT_THAT(refusal(kOneAndTwo), HasSubstr("has no scans: files that end in .pcd, .ply or .bin"));
  make({"7.pcd"});
  const std::string far = refusal(kOneAndTwo);
  EXPECT_THAT(far, testing::StartsWith("poses.txt: has no pose within 0.1 s of any scan in "));
  EXPECT_THAT(far, testing::EndsWith(": by their names these are from 7 (7.pcd) to 7, poses from 1 to 2"));
  EXPECT_THAT(refusal("1 4 0 0 0 0 0 0 1\n"), testing::StartsWith("poses.txt: has no pose of the number of any scan in "));
  EXPECT_THAT(refusal(kOneAndTwo, {.pairing = Pairing::order}), testing::StartsWith("poses.txt: has 2 poses for the 1 scans in "));
  EXPECT_THAT(refusal(kOneAndTwo, {.pairing = Pairing::number}), testing::EndsWith("has stamps, not numbers of scans, to pair by"));
  EXPECT_THAT(refusal("1 0 0 5 0 1 0 0 0 0 1 0\n", {.pairing = Pairing::stamp}), testing::EndsWith("has no stamps to pair by"));
  make({"007.ply"});
  EXPECT_THAT(refusal(kOneAndTwo), HasSubstr("has the same number in its name as "));
  make({"scan.pcd"});
  EXPECT_THAT(refusal(kOneAndTwo), testing::EndsWith("scan.pcd: has no number in its name by which to find its pose"));
}

TEST_F(ScanLogs, AreRefusedWhereThereIsNoFolder) {
  const Trajectory trajectory = parse_trajectory(kOneAndTwo, "poses.txt");
  EXPECT_THAT(test::thrown_message([&] { read_scan_log(folder / "none", trajectory, {}); }),
              HasSubstr("none: cannot be read as a folder of scans"));
}

TEST(ScanLog, PairsTheLogsOfOthers) {
  ALIGNABILITY_REQUIRE_SHARED_DATA(logs, "logs");
  const ScanLog real = read_scan_log(logs / "real-hall/scans", read_trajectory(logs / "real-hall/poses.txt"), {});
  EXPECT_EQ(real.scans.size(), 30u);
  EXPECT_EQ(real.scans.back().T_map_lidar.translation().x(), -13.423267);
  const ScanLog simulated = read_scan_log(logs / "simulated-hall/scans", read_trajectory(logs / "simulated-hall/poses_all_101.txt"), {});
  EXPECT_EQ(simulated.scans.size(), 26u);
  EXPECT_EQ(simulated.scans[1].T_map_lidar.translation().x(), 7.1);
  const ScanLog kitti = read_scan_log(logs / "kitti-00", read_trajectory(logs / "kitti-00/poses_lidar.txt"), {});
  EXPECT_EQ(kitti.scans.size(), 2u);
}

TEST(Cropping, LeavesNoReturnBeyondTheRange) {
  const Scan scan = cropped({.points = {{1.0f, 0.0f, 0.0f}, {0.0f, 3.0f, 4.0f}, {0.0f, 3.0f, 4.1f}}, .rings = 1, .columns = 3}, 5.0);
  EXPECT_TRUE(scan.points[0].allFinite() && scan.points[1].allFinite());
  EXPECT_TRUE(scan.points[2].array().isNaN().all());
  EXPECT_EQ(scan.columns, 3);
}

}  // namespace
}  // namespace alignability
