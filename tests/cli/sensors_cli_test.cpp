// SPDX-License-Identifier: BSD-3-Clause
// 2D scanners and several lidars on one robot, from the command line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/site_cli.hpp"

namespace alignability {
namespace {

using nlohmann::json;
using testing::HasSubstr;

const std::string kScanner =
    "elevation_deg: [0], azimuth_deg: {min: -135, max: 135, count: 541}, range: {min: 0.1, max: 30, stddev: 0.01}, rate: 25";

class SensorsCli : public test::SiteCli {
 protected:
  SensorsCli() {
    folder.write("scanner.yaml", "{name: scanner, " + kScanner + ", mount: {xyz: [0, 0, 0.2], rpy_deg: [0, 0, 0]}}");
    folder.write("corners.yaml", "{name: corners, lidars: [{name: a, " + kScanner +
                                     ", mount: {xyz: [0.2, 0.2, 0.2], rpy_deg: [0, 0, 45]}}, {name: b, " + kScanner +
                                     ", mount: {xyz: [-0.2, -0.2, 0.2], rpy_deg: [0, 0, -135]}}]}");
  }

  void scan(const std::string& sensor) const {
    ASSERT_EQ(run({"scan", "--scene", "world.sdf", "--sensor", sensor, "--at", "1.5,1.5,0.3", "-o", "scan.pcd"}).exit_code, 0);
  }
};

TEST_F(SensorsCli, ScoreA2dScanWithAndWithoutItsSensor) {
  scan("scanner.yaml");
  const json with = json::parse(run({"score", "scan.pcd", "--sensor", "scanner.yaml", "--json"}).out);
  EXPECT_GT(with["alpha"].get<double>(), 0.1);
  EXPECT_TRUE(with["eigenvalues"][2].is_null());
  EXPECT_EQ(with["weakest_direction"][2], 0.0);
  const json without = json::parse(run({"score", "scan.pcd", "--json"}).out);
  EXPECT_TRUE(without["eigenvalues"][2].is_null());
}

TEST_F(SensorsCli, ScoreTheScanOfSeveralLidarsTogether) {
  scan("corners.yaml");
  const test::Outcome outcome = run({"score", "scan.pcd", "--sensor", "corners.yaml", "--json", "--picture", "scan.png"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_GT(json::parse(outcome.out)["alpha"].get<double>(), 0.1);
  EXPECT_TRUE(exists("scan.png"));
}

TEST_F(SensorsCli, RefuseToScoreTheScanOfAnotherSensor) {
  scan("scanner.yaml");
  const test::Outcome outcome = run({"score", "scan.pcd", "--sensor", "corners.yaml"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("scan.pcd: has 541 points where the sensor's 2 lidars have 1082 beams"));
}

TEST_F(SensorsCli, MapWithSeveralLidarsIn2d) {
  ASSERT_EQ(run(test::kOccupancy).exit_code, 0);
  const std::vector<std::string> map{"map",          "--scene",   "world.sdf", "--occupancy", "occupancy.yaml", "--sensor",
                                     "corners.yaml", "--samples", "2",         "-o",          "corners_map"};
  test::Outcome outcome = run(map);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(bytes("corners_map.yaml"), HasSubstr("dimensions: 2"));
}

TEST_F(SensorsCli, MapByHeadingWhereTheSensorDoesNotSeeAllAround) {
  ASSERT_EQ(run(test::kOccupancy).exit_code, 0);
  const auto map = [&](const std::vector<std::string>& more) {
    std::vector<std::string> command{"map",          "--scene",   "world.sdf", "--occupancy", "occupancy.yaml", "--sensor",
                                     "scanner.yaml", "--samples", "1",         "-o",          "by_heading"};
    command.insert(command.end(), more.begin(), more.end());
    const test::Outcome outcome = run(command);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return bytes("by_heading.yaml");
  };
  EXPECT_THAT(map({}), HasSubstr("alpha_heading_7]"));
  const test::Outcome why =
      run({"explain", "1.5,1.5,1.6", "--scene", "world.sdf", "--sensor", "scanner.yaml", "--alignability", "by_heading.yaml"});
  ASSERT_EQ(why.exit_code, 0) << why.err;
  EXPECT_THAT(why.out, HasSubstr("heading        92 deg\n"));
  EXPECT_THAT(why.out, HasSubstr(" in this cell at the worst heading, "));
  EXPECT_THAT(why.out, HasSubstr(" at heading 90 deg, the best alpha "));
  const json turned = json::parse(
      run({"explain", "1.5,1.5,1.6", "--scene", "world.sdf", "--sensor", "scanner.yaml", "--alignability", "by_heading.yaml", "--json"})
          .out);
  EXPECT_EQ(turned["yaw"], 1.6);
  EXPECT_EQ(turned["map"]["alpha_by_heading"].size(), 8u);
  EXPECT_THAT(map({"--headings", "3"}), HasSubstr("alpha_heading_2]"));
  EXPECT_THAT(map({"--headings", "1"}), HasSubstr("weak_z]"));
}

TEST_F(SensorsCli, ExplainA2dScanByItsWalls) {
  const test::Outcome outcome =
      run({"explain", "1.5,1.5", "--scene", "world.sdf", "--sensor", "scanner.yaml", "--readings", "robust,information", "-o", "why"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("wall"));
  EXPECT_EQ(outcome.out.find("floor "), std::string::npos);
  EXPECT_TRUE(exists("why.png"));
}

TEST_F(SensorsCli, RefusePclIn2d) {
  scan("scanner.yaml");
  const test::Outcome outcome = run({"score", "scan.pcd", "--sensor", "scanner.yaml", "--engine", "pcl"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("the engine pcl knows no scans of two dimensions"));
}

}  // namespace
}  // namespace alignability
