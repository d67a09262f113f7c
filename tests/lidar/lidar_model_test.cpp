// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/lidar_model.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "tests/lidar/fixtures.hpp"

namespace alignability {
namespace {

using testing::HasSubstr;

constexpr double kPi = std::numbers::pi;
constexpr const char* kHdl32 = R"(name: Velodyne HDL-32E
elevation_deg: {min: -30.67, max: 10.67, count: 32}
azimuth_deg: {min: -180, max: 180, count: 2170}
range: {min: 0.5, max: 100, stddev: 0.008}
rate: 10
mount: {xyz: [0.1, 0, 1.9], rpy_deg: [0, 0, 90]}
)";

TEST(LidarModel, ReadsASensorFile) {
  const LidarModel model = parse_lidar_model(kHdl32, "hdl32e.yaml");
  EXPECT_EQ(model.name, "Velodyne HDL-32E");
  EXPECT_EQ(model.rings(), 32);
  EXPECT_NEAR(model.elevations[1] - model.elevations[0], 1.3335 * kPi / 180, 1e-4);
  EXPECT_EQ(model.columns(), 2170);
  EXPECT_EQ(model.range_max, 100.0);
  EXPECT_EQ(model.range_stddev, 0.008);
  EXPECT_EQ(model.yaml, kHdl32);
  EXPECT_TRUE((model.T_base_lidar * Eigen::Vector3d(1, 0, 0)).isApprox(Eigen::Vector3d(0.1, 1, 1.9), 1e-12));
}

TEST(LidarModel, TurnsTheMountAboutFixedAxesRollFirst) {
  const LidarModel model = parse_lidar_model(
      "{name: a, elevation_deg: [0], azimuth_deg: {min: 0, max: 360, count: 4}, range: {min: 0, max: 9, stddev: 0}, rate: 1, "
      "mount: {xyz: [0, 0, 0], rpy_deg: [90, 0, 90]}}",
      "a.yaml");
  // y goes to z by the roll and stays there under the yaw about the fixed z axis.
  EXPECT_TRUE((model.T_base_lidar * Eigen::Vector3d(0, 1, 0)).isApprox(Eigen::Vector3d(0, 0, 1), 1e-12));
}

TEST(LidarModel, ElevationsMayBeAList) {
  const LidarModel model = parse_lidar_model(
      "{name: a, elevation_deg: [5, -5, 1], azimuth_deg: {min: -45, max: 45, count: 3}, range: {min: 0, max: 9, stddev: 0}, rate: 1}",
      "a.yaml");
  ASSERT_EQ(model.rings(), 3);
  EXPECT_NEAR(model.elevations[1], -5 * kPi / 180, 1e-12);
  EXPECT_TRUE(model.T_base_lidar.isApprox(Eigen::Isometry3d::Identity()));
}

TEST(LidarModel, RingsMayBeATableOfElevationsAndAzimuthOffsets) {
  const LidarModel model = parse_lidar_model(
      "{name: a, rings_deg: [[10, 3], [-10, -3]], azimuth_deg: {min: -45, max: 45, count: 3}, range: {min: 0, max: 9, stddev: 0}, rate: 1}",
      "a.yaml");
  ASSERT_EQ(model.rings(), 2);
  const auto directions = beam_directions(model);
  ASSERT_EQ(directions.size(), 6u);
  const double deg = kPi / 180;
  EXPECT_NEAR(std::asin(directions[0].z()), 10 * deg, 1e-6);
  EXPECT_NEAR(std::atan2(directions[0].y(), directions[0].x()), -42 * deg, 1e-6);
  EXPECT_NEAR(std::asin(directions[5].z()), -10 * deg, 1e-6);
  EXPECT_NEAR(std::atan2(directions[5].y(), directions[5].x()), 42 * deg, 1e-6);
}

TEST(LidarModel, AzimuthsMayBeSectors) {
  const LidarModel model = parse_lidar_model(
      "{name: a, elevation_deg: [0], azimuth_deg: [{min: -150, max: -30, count: 3}, {min: 0, max: 0, count: 1}, {min: 30, max: 150, count: "
      "5}], "
      "range: {min: 0, max: 9, stddev: 0}, rate: 1}",
      "a.yaml");
  EXPECT_EQ(model.columns(), 9);
  EXPECT_FALSE(model.full_circle());
  std::vector<double> azimuths;
  for (const Eigen::Vector3f& direction : beam_directions(model)) {
    azimuths.push_back(std::round(std::atan2(direction.y(), direction.x()) * 180 / kPi));
  }
  EXPECT_THAT(azimuths, testing::ElementsAre(-150, -90, -30, 0, 30, 60, 90, 120, 150));
}

TEST(LidarModel, BeamsOfAFullCircleDoNotRepeatTheFirst) {
  LidarModel model = test::small_lidar();
  const auto directions = beam_directions(model);
  ASSERT_EQ(directions.size(), 36u);
  for (const auto& direction : directions) EXPECT_NEAR(direction.norm(), 1.0f, 1e-6f);
  EXPECT_NEAR(directions[0].x(), -std::cos(0.3), 1e-6);
  EXPECT_NEAR(directions[0].z(), -std::sin(0.3), 1e-6);
  EXPECT_NEAR(std::atan2(directions[11].y(), directions[11].x()), kPi - kPi / 6, 1e-6);
  EXPECT_TRUE(directions[12 + 6].isApprox(Eigen::Vector3f::UnitX(), 1e-6f));
}

TEST(LidarModel, OfOneRingLooksWhereMinAndMaxBothSay) {
  std::string text = kHdl32;
  const std::string span = "{min: -30.67, max: 10.67, count: 32}";
  text.replace(text.find(span), span.size(), "{min: -3, max: -3, count: 1}");
  const LidarModel model = parse_lidar_model(text, "s.yaml");
  ASSERT_EQ(model.rings(), 1);
  EXPECT_NEAR(model.elevations[0], -3.0 * kPi / 180.0, 1e-12);
}

TEST(LidarModel, OfSectorsSeesNoFullCircle) {
  LidarModel model = test::small_lidar();
  EXPECT_TRUE(model.full_circle());
  model.sectors = {{.min = -1.0, .max = 1.0, .columns = 5}};
  EXPECT_FALSE(model.full_circle());
  model.sectors.push_back({.min = 2.0, .max = 3.0, .columns = 5});
  EXPECT_FALSE(model.full_circle());
}

TEST(LidarModel, BeamsOfALimitedFieldOfViewReachBothEnds) {
  LidarModel model = test::small_lidar();
  model.elevations = {0.0};
  model.sectors = {{.min = -1.0, .max = 1.0, .columns = 5}};
  const auto directions = beam_directions(model);
  EXPECT_NEAR(std::atan2(directions.front().y(), directions.front().x()), -1.0, 1e-6);
  EXPECT_NEAR(std::atan2(directions.back().y(), directions.back().x()), 1.0, 1e-6);
}

struct Fault {
  const char* what;
  const char* replaced;
  const char* by;
  const char* message;
};

std::string list_of(std::size_t count, const std::string& item) {
  std::string list = "[";
  for (std::size_t i = 0; i < count; ++i) list.append(i == 0 ? "" : ", ").append(item);
  return list + "]";
}

const std::string kThousandAndMoreAngles = list_of(1025, "0");
const std::string kThousandAndMoreRings = list_of(1025, "[0, 0]");

class MalformedSensorFile : public testing::TestWithParam<Fault> {};

TEST_P(MalformedSensorFile, IsRefusedAtTheKey) {
  std::string text = kHdl32;
  const std::size_t at = text.find(GetParam().replaced);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, std::string_view(GetParam().replaced).size(), GetParam().by);
  EXPECT_EQ(test::fault_of([&] { parse_lidar_model(text, "s.yaml"); }), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Table, MalformedSensorFile,
    testing::Values(
        Fault{"MissingName", "name: Velodyne HDL-32E\n", "", "s.yaml:1:1: missing key 'name'"},
        Fault{"MisspeltKey", "rate: 10", "rte: 10", "s.yaml:5:1: unknown key 'rte' (did you mean 'rate'?)"},
        Fault{"UnknownKeyInSpan", "count: 32", "count: 32, step: 1", "s.yaml:2:53: unknown key 'step'"},
        Fault{"ElevationAboveTheZenith", "max: 10.67", "max: 110", "s.yaml:2:35: 'max' must be from -90 to 90, not 110"},
        Fault{"TooManyRings", "count: 32", "count: 100000", "s.yaml:2:49: 'count' must be a whole number from 1 to 1024, not 100000"},
        Fault{"TooManyBeams", "count: 2170", "count: 1000000", "s.yaml:3:43: 'count' must be a whole number from 1 to 131072, not 1000000"},
        Fault{"HalfAColumn", "count: 2170", "count: 0.5", "s.yaml:3:43: 'count' must be a whole number from 1 to 131072, not 0.5"},
        Fault{"ReversedSpan", "min: -180, max: 180", "min: 180, max: -180", "s.yaml:3:30: 'max' must be greater than 'min', which is 180"},
        Fault{"MoreThanACircle", "min: -180, max: 180", "min: -200, max: 200", "s.yaml:3:14: 'azimuth_deg' must span at most 360 degrees"},
        Fault{"OneBeamForASpan", "count: 32", "count: 1", "s.yaml:2:49: 'count' of 1 needs 'min' and 'max' to be equal"},
        Fault{"EmptyList", "{min: -30.67, max: 10.67, count: 32}", "[]", "s.yaml:2:16: 'elevation_deg' must list from 1 to 1024 angles"},
        Fault{"TooLongList", "{min: -30.67, max: 10.67, count: 32}", kThousandAndMoreAngles.c_str(),
              "s.yaml:2:16: 'elevation_deg' must list from 1 to 1024 angles"},
        Fault{"NotANumber", "stddev: 0.008", "stddev: .nan", "s.yaml:4:37: 'stddev' must be from 0 to 10000, not .nan"},
        Fault{"NegativeNoise", "stddev: 0.008", "stddev: -1", "s.yaml:4:37: 'stddev' must be from 0 to 10000, not -1"},
        Fault{"RangesReversed", "max: 100", "max: 0.4", "s.yaml:4:24: 'max' must be greater than 0.5 and at most 10000, not 0.4"},
        Fault{"StandingStill", "rate: 10", "rate: 0", "s.yaml:5:7: 'rate' must be greater than 0 and at most 1e+06, not 0"},
        Fault{"MountOfTwoNumbers", "[0.1, 0, 1.9]", "[0.1, 0]", "s.yaml:6:14: 'xyz' must be a list of 3 numbers, not 2"}),
    [](const auto& instance) { return instance.param.what; });

class MalformedRings : public testing::TestWithParam<Fault> {};

constexpr const char* kTable = R"(name: a
rings_deg: [[1, 0], [-1, 2]]
azimuth_deg: [{min: -90, max: -10, count: 9}, {min: 10, max: 90, count: 9}]
range: {min: 0.5, max: 100, stddev: 0.008}
rate: 10
)";

TEST_P(MalformedRings, AreRefusedAtTheKey) {
  std::string text = kTable;
  const std::size_t at = text.find(GetParam().replaced);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, std::string_view(GetParam().replaced).size(), GetParam().by);
  EXPECT_EQ(test::fault_of([&] { parse_lidar_model(text, "s.yaml"); }), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Table, MalformedRings,
    testing::Values(
        Fault{"RingsTwice", "name: a\n", "name: a\nelevation_deg: [0]\n",
              "s.yaml:3:12: 'rings_deg' stands in place of 'elevation_deg'; give one of them"},
        Fault{"NoRings", "[[1, 0], [-1, 2]]", "[]", "s.yaml:2:12: 'rings_deg' must list from 1 to 1024 rings [elevation, azimuth offset]"},
        Fault{"TooManyRings", "[[1, 0], [-1, 2]]", kThousandAndMoreRings.c_str(),
              "s.yaml:2:12: 'rings_deg' must list from 1 to 1024 rings [elevation, azimuth offset]"},
        Fault{"NoBeamsLeft", "count: 9}, {", "count: 2097152}, {",
              "s.yaml:3:14: 'azimuth_deg' must have at most 4194304 beams, all rings together"},
        Fault{"NoPairs", "[[1, 0], [-1, 2]]", "[1, -1]", "s.yaml:2:13: 'rings_deg' must be a list of points [x, y]"},
        Fault{"AboveTheZenith", "[-1, 2]", "[-91, 2]", "s.yaml:2:12: an elevation of 'rings_deg' must be from -90 to 90, not -91"},
        Fault{"OffsetBeyondATurn", "[-1, 2]", "[-1, 400]", "s.yaml:2:26: 'rings_deg' must be from -360 to 360, not 400"},
        Fault{"NoSectors", "[{min: -90, max: -10, count: 9}, {min: 10, max: 90, count: 9}]", "[]",
              "s.yaml:3:14: 'azimuth_deg' must list at least one sector"},
        Fault{"NoMappings", "[{min: -90, max: -10, count: 9}, {min: 10, max: 90, count: 9}]", "[1]",
              "s.yaml:3:15: 'azimuth_deg' must be a list of 'key: value' pairs"},
        Fault{"SectorsOverlap", "min: 10", "min: -20", "s.yaml:3:53: 'min' must be greater than the 'max' of the sector before, -10"},
        Fault{"SectorsTouch", "min: 10", "min: -10", "s.yaml:3:53: 'min' must be greater than the 'max' of the sector before, -10"},
        Fault{"MoreThanATurn", "max: 90", "max: 271", "s.yaml:3:14: 'azimuth_deg' must span at most 360 degrees"},
        Fault{"TurnThatRepeatsTheFirst", "max: 90", "max: 270", "s.yaml:3:62: 'max' must be less than a turn from the first 'min', -90"},
        Fault{"TooManyBeams", "count: 9}]", "count: 2097144}]",
              "s.yaml:3:73: 'count' must be a whole number from 1 to 2097143, not 2097144"}),
    [](const auto& instance) { return instance.param.what; });

}  // namespace
}  // namespace alignability
