// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/trajectory.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/core/temporary_folder.hpp"
#include "tests/core/thrown_message.hpp"
#include "tests/shared_data.hpp"

namespace alignability {
namespace {

const std::filesystem::path kFile = "poses.txt";

// A quarter turn to the left, 1, 2, 3 m off.
void expect_a_left_turn(const Eigen::Isometry3d& pose) {
  EXPECT_TRUE(pose.translation().isApprox(Eigen::Vector3d(1.0, 2.0, 3.0)));
  EXPECT_TRUE((pose.linear() * Eigen::Vector3d::UnitX()).isApprox(Eigen::Vector3d::UnitY(), 1e-9));
  EXPECT_TRUE((pose.linear() * pose.linear().transpose()).isIdentity(1e-12));
}

TEST(Trajectory, ReadsTumPoses) {
  const Trajectory trajectory =
      parse_trajectory("# stamp tx ty tz qx qy qz qw\n10.5 0 0 0 0 0 0 1\r\n\n  11 1 2 +3e0 0 0 0.70711 0.70711  \n", kFile);
  EXPECT_EQ(trajectory.format, TrajectoryFormat::tum);
  ASSERT_EQ(trajectory.poses.size(), 2u);
  EXPECT_EQ(trajectory.poses[0].stamp, 10.5);
  EXPECT_TRUE(trajectory.poses[0].pose.isApprox(Eigen::Isometry3d::Identity()));
  expect_a_left_turn(trajectory.poses[1].pose);
}

TEST(Trajectory, ReadsTumPosesWithTheNumberOfTheScanBefore) {
  const Trajectory trajectory = parse_trajectory("3 11.25 0 0 0 0 0 0 1\n6 12.75 1 2 3 0 0 -0.70711 -0.70711\n", kFile);
  EXPECT_EQ(trajectory.format, TrajectoryFormat::numbered);
  ASSERT_EQ(trajectory.poses.size(), 2u);
  EXPECT_EQ(trajectory.poses[1].number, 6u);
  EXPECT_EQ(trajectory.poses[1].stamp, 12.75);
  expect_a_left_turn(trajectory.poses[1].pose);
}

TEST(Trajectory, ReadsKittiPosesAndNumbersThem) {
  const Trajectory trajectory = parse_trajectory("1 0 0 0 0 1 0 0 0 0 1 0\n0 -1 0 1 1 0 0 2 0 0 1 3", kFile);
  EXPECT_EQ(trajectory.format, TrajectoryFormat::kitti);
  ASSERT_EQ(trajectory.poses.size(), 2u);
  EXPECT_EQ(trajectory.poses[1].number, 1u);
  expect_a_left_turn(trajectory.poses[1].pose);
}

struct Malformed {
  std::string text;
  std::string message;
};

TEST(Trajectory, SaysWhereAndWhyItIsWrong) {
  const std::string good = "1 0 0 0 0 0 0 1\n";
  const std::vector<Malformed> table{
      {"", "poses.txt: holds no poses"},
      {"# only a comment\n\n", "poses.txt: holds no poses"},
      {"1 2 3\n",
       "poses.txt:1:1: a pose has 8 values (TUM: stamp x y z qx qy qz qw), 9 (the number of the scan before these) or 12 (KITTI"},
      {"1,0,0,0,0,0,0,1\n", "poses.txt:1:1: a pose has 8 values"},
      {good + "2 0 0 0 0 0", "poses.txt:2:1: there must be 8 values, as on the lines before, not 6"},
      {good + "# cut\n2 0 0 0 0 0 0 1 9\n", "poses.txt:3:1: there must be 8 values, as on the lines before, not 9"},
      {good + "2 0 nan 0 0 0 0 1\n", "poses.txt:2:5: a coordinate must be from -1e+07 to 1e+07, not 'nan'"},
      {good + "2 0 0 1e8 0 0 0 1\n", "poses.txt:2:7: a coordinate must be from -1e+07 to 1e+07, not '1e8'"},
      {good + "2 0 0 x 0 0 0 1\n", "poses.txt:2:7: a coordinate must be a number, not 'x'"},
      {good + "2 0 0 1.5m 0 0 0 1\n", "poses.txt:2:7: a coordinate must be a number, not '1.5m'"},
      {good + "inf 0 0 0 0 0 0 1\n", "poses.txt:2:1: a stamp must be from 0 to 1e+15, not 'inf'"},
      {good + "-2 0 0 0 0 0 0 1\n", "poses.txt:2:1: a stamp must be from 0 to 1e+15, not '-2'"},
      {good + "2 0 0 0 nan 0 0 1\n", "poses.txt:2:9: a part of a quaternion must be a finite number, not 'nan'"},
      {good + "2 0 0 0 0 0 0.5 0.5\n", "poses.txt:2:9: the quaternion must be of length 1, not 0.707"},
      {good + "2 0 0 0 0 0 0 0\n", "poses.txt:2:9: the quaternion must be of length 1, not 0"},
      {good + "2 0 0 0 0 0 0 1e200\n", "poses.txt:2:9: the quaternion must be of length 1, not inf"},
      {good + good, "poses.txt:2:1: the stamp 1 must be later than 1 of line 1"},
      {good + "3 0 0 0 0 0 0 1\n2 0 0 0 0 0 0 1\n", "poses.txt:3:1: the stamp 2 must be later than 3 of line 2"},
      {"1.5 7 0 0 0 0 0 0 1\n", "poses.txt:1:1: of 9 values the first is the number of the scan, a whole one, not '1.5'"},
      {"-1 7 0 0 0 0 0 0 1\n", "poses.txt:1:1: of 9 values the first is the number of the scan, a whole one, not '-1'"},
      {"2 7 0 0 0 0 0 0 1\n2 8 0 0 0 0 0 0 1\n", "poses.txt:2:1: the number 2 must be greater than 2 of line 1"},
      {"2 7 0 0 0 0 0 0 1\n3 7 0 0 0 0 0 0 1\n", "poses.txt:2:3: the stamp 7 must be later than 7 of line 1"},
      {"1 0 0 0 0 1 0 0 0 0 1\n", "poses.txt:1:1: a pose has 8 values"},
      {"1 0 0 0 0 1 0 0 0 0 nan 0\n", "poses.txt:1:21: a part of a rotation must be a finite number, not 'nan'"},
      {"2 0 0 0 0 1 0 0 0 0 1 0\n", "poses.txt:1:1: the first three columns of the matrix must be a rotation"},
      {"1 0 0 0 0 1 0 0 0 0 -1 0\n", "poses.txt:1:1: the first three columns of the matrix must be a rotation"},
      {std::string("\x89PNG\r\n\x1a\n\0\0", 10), "poses.txt:1:1: a pose has 8 values"},
  };
  for (const Malformed& malformed : table) {
    SCOPED_TRACE(malformed.text);
    EXPECT_THAT(test::thrown_message([&] { parse_trajectory(malformed.text, kFile); }), testing::StartsWith(malformed.message));
  }
}

TEST(Trajectory, IsRefusedWhereThereIsNoFile) {
  const test::TemporaryFolder folder;
  EXPECT_THAT(test::thrown_message([&] { read_trajectory(folder / "none.txt"); }), testing::HasSubstr("none.txt: "));
}

TEST(Trajectory, ReadsThoseOfOthers) {
  ALIGNABILITY_REQUIRE_SHARED_DATA(logs, "logs");
  const Trajectory real = read_trajectory(logs / "real-hall/poses.txt");
  EXPECT_EQ(real.format, TrajectoryFormat::numbered);
  ASSERT_EQ(real.poses.size(), 30u);
  EXPECT_EQ(real.poses.back().number, 87u);
  EXPECT_EQ(real.poses.back().pose.translation().x(), -13.423267);
  const Trajectory simulated = read_trajectory(logs / "simulated-hall/poses_all_101.txt");
  EXPECT_EQ(simulated.format, TrajectoryFormat::tum);
  EXPECT_EQ(simulated.poses.size(), 101u);
  const Trajectory kitti = read_trajectory(logs / "kitti-00/poses_lidar.txt");
  EXPECT_EQ(kitti.format, TrajectoryFormat::tum);
  EXPECT_EQ(kitti.poses.size(), 6u);
}

}  // namespace
}  // namespace alignability
