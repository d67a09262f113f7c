// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/carmen_log.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "tests/core/thrown_message.hpp"
#include "tests/shared_data.hpp"

namespace alignability {
namespace {

constexpr double kPi = std::numbers::pi;
const std::filesystem::path kFile = "site.log";

double azimuth(const Scan& scan, std::size_t beam) { return std::atan2(scan.points[beam].y(), scan.points[beam].x()); }

TEST(CarmenLog, ReadsFlaserLinesAndPassesOverOthers) {
  const auto scans = parse_carmen_log(
      "# a comment\nPARAM robot_length 0.5\nODOM 0 0 0 0 0 0 1 host 1\n"
      "FLASER 3 1.0 2.0 81.91 4.0 5.0 0.5 9 9 9 100.5 host 101.5\n\nFLASER 2 1 0 0 0 0 0 0 0 7 host 7",
      kFile);
  ASSERT_EQ(scans.size(), 2u);
  const Scan& scan = *scans[0].scan;
  ASSERT_EQ(scan.points.size(), 3u);
  EXPECT_EQ(scan.rings, 1);
  EXPECT_NEAR(azimuth(scan, 0), -0.5 * kPi, 1e-6);
  EXPECT_NEAR(azimuth(scan, 1), 0.0, 1e-6);
  EXPECT_FLOAT_EQ(scan.points[1].norm(), 2.0f);
  EXPECT_TRUE(scan.points[2].array().isNaN().all()) << "81.91 m says that nothing came back";
  EXPECT_EQ(scans[0].T_map_lidar.translation(), Eigen::Vector3d(4.0, 5.0, 0.0));
  EXPECT_NEAR(scans[0].T_map_lidar.linear()(1, 0), std::sin(0.5), 1e-12);
  EXPECT_EQ(scans[0].stamp, 100.5);
  EXPECT_EQ(scans[0].file, "site.log:4");
  EXPECT_EQ(scans[1].file, "site.log:6");
  EXPECT_TRUE(std::isnan(scans[1].scan->points[1].x())) << "a range of 0 is none";
}

TEST(CarmenLog, AnEvenNumberOfFlaserBeamsHasNoneAtTheLeft) {
  const auto scans = parse_carmen_log("FLASER 4 1 1 1 1 0 0 0 0 0 0 1 host 1\n", kFile);
  EXPECT_NEAR(azimuth(*scans[0].scan, 0), -0.5 * kPi, 1e-6);
  EXPECT_NEAR(azimuth(*scans[0].scan, 3), 0.25 * kPi, 1e-6);
}

TEST(CarmenLog, ReadsRobotlaserLines) {
  const auto scans =
      parse_carmen_log("ROBOTLASER1 0 -1.0 2.0 0.5 20.0 0.01 0 3 1.5 20.0 2.5 2 7 8 1 2 0.3 9 9 9 0 0 0.1 0.2 1e6 55.5 host 56\n", kFile);
  ASSERT_EQ(scans.size(), 1u);
  const Scan& scan = *scans[0].scan;
  EXPECT_NEAR(azimuth(scan, 0), -1.0, 1e-6);
  EXPECT_TRUE(std::isnan(scan.points[1].x()));
  EXPECT_NEAR(azimuth(scan, 2), 0.0, 1e-6);
  EXPECT_EQ(scans[0].T_map_lidar.translation(), Eigen::Vector3d(1.0, 2.0, 0.0));
  EXPECT_EQ(scans[0].stamp, 55.5);
}

TEST(CarmenLog, IsKnownByItsName) {
  for (const char* name : {"a.log", "a.LOG", "a/b.clf"}) EXPECT_TRUE(is_carmen_log(name)) << name;
  for (const char* name : {"a", "log", "a.pcd", "a.log/"}) EXPECT_FALSE(is_carmen_log(name)) << name;
}

struct Malformed {
  std::string text;
  std::string message;
};

TEST(CarmenLog, IsRefusedWhereItIsMalformed) {
  const std::string good = "FLASER 2 1 2 0 0 0 0 0 0 1 host 1\n";
  const Malformed table[] = {
      {"", "site.log: holds no scans"},
      {"ODOM 0 0 0 0 0 0 1 host 1\n", "site.log: holds no scans"},
      {"FLASER\n", "site.log:1:1: the line ends where the count of beams must follow"},
      {good + "FLASER 2 1 2 0 0", "site.log:2:1: after the ranges 9 values must follow, not 2"},
      {good + "FLASER 3 1 2 0 0 0 0 0 0 1 host 1\n", "site.log:2:1: after the ranges 9 values must follow, not 8"},
      {good + "FLASER 1 1 2 0 0 0 0 0 0 1 host 1\n", "site.log:2:1: after the ranges 9 values must follow, not 10"},
      {"FLASER 3 1 2", "site.log:1:8: the count of beams is 3, but only 2 values follow"},
      {"FLASER 0 0 0 0 0 0 0 1 host 1\n", "site.log:1:8: the count of beams must be from 1 to 65536, not '0'"},
      {"FLASER -1 0 0 0 0 0 0 1 host 1\n", "site.log:1:8: the count of beams must be from 1 to 65536, not '-1'"},
      {"FLASER 4000000000 1 2\n", "site.log:1:8: the count of beams must be from 1 to 65536, not '4000000000'"},
      {"FLASER 65536 1 2\n", "site.log:1:8: the count of beams is 65536, but only 2 values follow"},
      {"FLASER 1.5 1 2 0 0 0 0 0 0 1 host 1\n", "site.log:1:8: the count of beams must be a whole number"},
      {"FLASER x 1 2\n", "site.log:1:8: the count of beams must be a number, not 'x'"},
      {"FLASER 2 1 nan 0 0 0 0 0 0 1 host 1\n", "site.log:1:12: a range must be at least 0, not 'nan'"},
      {"FLASER 2 1 -2 0 0 0 0 0 0 1 host 1\n", "site.log:1:12: a range must be at least 0, not '-2'"},
      {"FLASER 2 1 2m 0 0 0 0 0 0 1 host 1\n", "site.log:1:12: a range must be a number, not '2m'"},
      {"FLASER 2 1 2 0 1e8 0 0 0 0 1 host 1\n", "site.log:1:16: a coordinate must be from -1e+07 to 1e+07, not '1e8'"},
      {"FLASER 2 1 2 0 0 inf 0 0 0 1 host 1\n", "site.log:1:18: a heading must be a finite number, not 'inf'"},
      {"FLASER 2 1 2 0 0 0 0 0 0 host 1 1\n", "site.log:1:26: a stamp must be a number, not 'host'"},
      {"ROBOTLASER1 0 -1 2 0.5 20 0.01 0 2 1 2 5 7\n", "site.log:1:40: the count of remissions is 5, but only 1 values follow"},
      {"ROBOTLASER1 0 -1 2 0.5 20 0.01 0 2 1 2 0 1 2 3\n", "site.log:1:1: after the ranges 14 values must follow, not 3"},
      {"ROBOTLASER1 0 -1 2 0.5 0 0.01 0 2 1 2 0 1 2 3\n", "site.log:1:24: the largest range must be greater than 0, not '0'"},
      {"ROBOTLASER1 0 -1 2\n", "site.log:1:18: the line ends where the step between beams must follow"},
  };
  for (const Malformed& malformed : table) {
    SCOPED_TRACE(malformed.text);
    EXPECT_THAT(test::thrown_message([&] { parse_carmen_log(malformed.text, kFile); }), testing::StartsWith(malformed.message));
  }
}

TEST(CarmenLog, ReadsThatOfOthers) {
  ALIGNABILITY_REQUIRE_SHARED_DATA(log, "logs/csail-2d/csail.corrected.log");
  const auto scans = read_carmen_log(log);
  ASSERT_EQ(scans.size(), 406u);
  for (const PosedScan& posed : scans) EXPECT_EQ(posed.scan->points.size(), 361u);
  EXPECT_EQ(scans[1].T_map_lidar.translation().z(), 0.0);
}

}  // namespace
}  // namespace alignability
