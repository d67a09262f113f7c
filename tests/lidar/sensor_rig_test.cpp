// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/sensor_rig.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/pose.hpp"
#include "lidar/simulate_scan.hpp"
#include "tests/lidar/fixtures.hpp"

namespace alignability {
namespace {

constexpr const char* kTwo = R"(name: two
lidars:
  - name: left
    elevation_deg: &level [0]
    azimuth_deg: &ahead {min: -90, max: 90, count: 181}
    range: &reach {min: 0.5, max: 20, stddev: 0.01}
    rate: 25
    mount: {xyz: [1, 0.5, 0.2], rpy_deg: [0, 0, 45]}
  - name: right
    elevation_deg: *level
    azimuth_deg: *ahead
    range: *reach
    rate: 25
    mount: {xyz: [-1, -0.5, 0.2], rpy_deg: [0, 0, -135]}
)";

Scene room() { return Scene({make_box({12, 10, 6})}); }

TEST(SensorRig, ReadsALidarAsARigOfOne) {
  const SensorRig rig = parse_sensor_rig(
      "{name: a, elevation_deg: [0], azimuth_deg: {min: 0, max: 360, count: 4}, range: {min: 0, max: 9, stddev: 0}, rate: 1, "
      "mount: {xyz: [1, 2, 3], rpy_deg: [0, 0, 0]}}",
      "a.yaml");
  ASSERT_EQ(rig.lidars.size(), 1u);
  EXPECT_EQ(rig.name, "a");
  EXPECT_TRUE(rig.is_planar());
  EXPECT_EQ(rig.yaml, rig.lidars.front().yaml);
  EXPECT_TRUE(rig.T_base_scan().translation().isApprox(Eigen::Vector3d(1, 2, 3)));
}

TEST(SensorRig, ReadsSeveralLidarsEachWithItsMount) {
  const SensorRig rig = parse_sensor_rig(kTwo, "two.yaml");
  ASSERT_EQ(rig.lidars.size(), 2u);
  EXPECT_EQ(rig.name, "two");
  EXPECT_EQ(rig.yaml, kTwo);
  EXPECT_EQ(rig.beams(), 362u);
  EXPECT_EQ(rig.lidars[1].name, "right");
  EXPECT_TRUE(
      (rig.lidars[1].T_base_lidar * Eigen::Vector3d(1, 0, 0)).isApprox(Eigen::Vector3d(-1 - std::sqrt(0.5), -0.5 - std::sqrt(0.5), 0.2)));
  EXPECT_TRUE(rig.T_base_scan().isApprox(Eigen::Isometry3d::Identity()));
  EXPECT_TRUE(rig.is_planar());
}

TEST(SensorRig, SaysTheLeastRangeAndTheMostNoise) {
  SensorRig rig = parse_sensor_rig(kTwo, "two.yaml");
  rig.lidars[0].range_min = 0.1;
  rig.lidars[1].range_stddev = 0.03;
  EXPECT_EQ(rig.range_min(), 0.1);
  EXPECT_EQ(rig.range_stddev(), 0.03);
  EXPECT_EQ(rig.rate(), 25.0);
}

TEST(LidarModel, IsPlanarWithOneRingThatIsLevelOnTheRobotEitherSideUp) {
  LidarModel model = test::small_lidar();
  EXPECT_FALSE(model.is_planar());
  model.elevations = {0.0};
  EXPECT_TRUE(model.is_planar());
  const auto turned = [&](double angle, const Eigen::Vector3d& axis) {
    model.T_base_lidar = Eigen::Isometry3d(Eigen::AngleAxisd(angle, axis));
    return model.is_planar();
  };
  EXPECT_TRUE(turned(2.0, Eigen::Vector3d::UnitZ()));
  EXPECT_TRUE(turned(std::numbers::pi, Eigen::Vector3d::UnitX()));
  EXPECT_TRUE(turned(radians(0.9), Eigen::Vector3d::UnitY()));
  EXPECT_FALSE(turned(radians(1.1), Eigen::Vector3d::UnitY()));
  EXPECT_FALSE(turned(radians(90), Eigen::Vector3d::UnitX()));
  model.T_base_lidar.setIdentity();
  model.elevations = {radians(5)};
  EXPECT_FALSE(model.is_planar());
}

// Every point on a wall, so that each was taken from its lidar's own place and turned by its own mount.
TEST(SimulateRigScan, JoinsTheLidarsInBaseLink) {
  const SensorRig rig = parse_sensor_rig(kTwo, "two.yaml");
  Eigen::Isometry3d T_map_base = Eigen::Isometry3d::Identity();
  T_map_base.translation() << 0.5, -1.0, 0.0;
  T_map_base.rotate(Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitZ()));
  const Scan scan = simulate_rig_scan(room(), rig, T_map_base);
  ASSERT_EQ(scan.points.size(), 362u);
  ASSERT_EQ(scan.parts.size(), 2u);
  EXPECT_FALSE(scan.organized());
  for (const Eigen::Vector3f& point : scan.points) {
    EXPECT_NEAR(point.z(), 0.2, 1e-5);
    const Eigen::Vector3d off = (T_map_base * point.cast<double>()).cwiseAbs() - Eigen::Vector3d(6, 5, 3);
    EXPECT_NEAR(off.maxCoeff(), 0.0, 1e-5);
  }
  EXPECT_TRUE(viewpoint(scan, 180).isApprox(Eigen::Vector3d(1, 0.5, 0.2)));
  EXPECT_TRUE(viewpoint(scan, 181).isApprox(Eigen::Vector3d(-1, -0.5, 0.2)));
}

TEST(SimulateRigScan, GivesOneLidarWhatItSeesAlone) {
  LidarModel lidar = test::small_lidar();
  lidar.range_stddev = 0.02;
  lidar.T_base_lidar = Eigen::Translation3d(0.3, 0.0, 0.5) * Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitY());
  const Scan alone = simulate_scan(room(), lidar, lidar.T_base_lidar, {}, NoiseKey{1, 2, 3});
  const Scan as_rig = simulate_rig_scan(room(), lidar, Eigen::Isometry3d::Identity(), {}, NoiseKey{1, 2, 3});
  EXPECT_EQ(alone.points, as_rig.points);
  EXPECT_TRUE(as_rig.parts.empty());
}

TEST(SimulateRigScan, DrawsNoiseOfEachLidarApart) {
  SensorRig rig = test::small_lidar();
  rig.lidars.front().range_stddev = 0.02;
  rig.lidars.push_back(rig.lidars.front());
  const Scan scan = simulate_rig_scan(room(), rig, Eigen::Isometry3d::Identity(), {}, NoiseKey{1, 2, 3});
  for (std::size_t i = 0; i < 36; ++i) EXPECT_NE(scan.points[i], scan.points[36 + i]);
}

TEST(SimulateRigScan, MeasuresRangesFromEachLidar) {
  SensorRig rig = parse_sensor_rig(kTwo, "two.yaml");
  const Scan scan = simulate_rig_scan(room(), rig, Eigen::Isometry3d::Identity(), {.range_max = 6.0});
  std::size_t seen = 0;
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    if (!scan.points[i].allFinite()) continue;
    ++seen;
    EXPECT_LE((scan.points[i].cast<double>() - viewpoint(scan, i)).norm(), 6.0 + 1e-5);
  }
  EXPECT_GT(seen, 0u);
  EXPECT_LT(seen, scan.points.size());
}

TEST(SimulateScan, ATiltedLidarSeesItsSectorTilted) {
  LidarModel lidar = test::small_lidar();
  lidar.elevations = {0.0};
  lidar.sectors = {{.min = radians(-120), .max = radians(-60), .columns = 7}, {.min = radians(60), .max = radians(120), .columns = 7}};
  // Rolled by 90 degrees its left looks up and its right down; nothing ahead, nothing behind, nothing beside.
  lidar.T_base_lidar = Eigen::Isometry3d(Eigen::AngleAxisd(radians(90), Eigen::Vector3d::UnitX()));
  const Scan scan = simulate_rig_scan(room(), lidar, Eigen::Isometry3d::Identity());
  ASSERT_EQ(scan.points.size(), 14u);
  for (std::size_t i = 0; i < 14; ++i) {
    const Eigen::Vector3d in_map = lidar.T_base_lidar * scan.points[i].cast<double>();
    EXPECT_NEAR(in_map.z(), i < 7 ? -3.0 : 3.0, 1e-5);
    EXPECT_NEAR(in_map.y(), 0.0, 1e-5);
  }
}

TEST(ToldApart, KnowsTheLidarsOfAJoinedScanAgain) {
  const SensorRig rig = parse_sensor_rig(kTwo, "two.yaml");
  const Scan scan = simulate_rig_scan(room(), rig, Eigen::Isometry3d::Identity());
  Scan forgotten{.points = scan.points, .rings = 1, .columns = scan.columns};
  const Scan again = told_apart(forgotten, rig);
  EXPECT_EQ(again.points, scan.points);
  ASSERT_EQ(again.parts.size(), 2u);
  EXPECT_EQ(again.parts[1].begin, 181u);
  forgotten.points.pop_back();
  EXPECT_THROW(told_apart(forgotten, rig), std::invalid_argument);
}

TEST(ToldApart, DropsWhatIsTooNearToItsOwnLidar) {
  SensorRig rig = parse_sensor_rig(kTwo, "two.yaml");
  const Scan scan = simulate_rig_scan(room(), rig, Eigen::Isometry3d::Identity());
  rig.lidars[1].range_min = 100.0;
  const Scan again = told_apart({.points = scan.points, .rings = 1, .columns = scan.columns}, rig);
  EXPECT_TRUE(again.points[0].allFinite());
  EXPECT_FALSE(again.points[181].allFinite());
}

struct Fault {
  const char* what;
  const char* replaced;
  const char* by;
  const char* message;
};

class MalformedRig : public testing::TestWithParam<Fault> {};

TEST_P(MalformedRig, IsRefusedAtTheKey) {
  std::string text = kTwo;
  const std::size_t at = text.rfind(GetParam().replaced);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, std::string_view(GetParam().replaced).size(), GetParam().by);
  EXPECT_EQ(test::fault_of([&] { parse_sensor_rig(text, "s.yaml"); }), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Table, MalformedRig,
    testing::Values(Fault{"MissingName", "name: two\n", "", "s.yaml:1:1: missing key 'name'"},
                    Fault{"UnknownKeyBeside", "name: two\n", "name: two\nweight: 3\n", "s.yaml:2:1: unknown key 'weight'"},
                    Fault{"UnknownKeyOfALidar", "rate: 25", "rte: 25", "s.yaml:13:5: unknown key 'rte' (did you mean 'rate'?)"},
                    Fault{"AnotherRate", "rate: 25", "rate: 10", "s.yaml:13:11: 'rate' must be that of the first lidar, 25"},
                    Fault{"TiltedBesideLevel", "rpy_deg: [0, 0, -135]", "rpy_deg: [0, 30, 0]",
                          "s.yaml:9:11: of lidars scored together all see in 2D, by one level ring, or none"},
                    Fault{"NoMappings", "lidars:\n", "lidars: [1, 2]\nothers:\n",
                          "s.yaml:2:10: 'lidars' must be a list of 'key: value' pairs"},
                    Fault{"NoList", "lidars:\n", "lidars: 1\nothers:\n", "s.yaml:2:9: 'lidars' must be a list of 'key: value' pairs"}),
    [](const auto& instance) { return instance.param.what; });

TEST(SensorRig, RefusesNoLidarsAndTooMany) {
  EXPECT_EQ(test::fault_of([] { parse_sensor_rig("{name: a, lidars: []}", "s.yaml"); }),
            "s.yaml:1:19: 'lidars' must list from 1 to 16 lidars");
}

TEST(LidarModel, RefusesAFileOfSeveralLidars) {
  EXPECT_EQ(test::fault_of([] { parse_lidar_model(kTwo, "s.yaml"); }),
            "s.yaml:3:3: several lidars are not taken here; give the file of one");
}

TEST(SensorRig, ReadsTheSensorsWeShip) {
  const std::filesystem::path sensors = std::filesystem::path(ALIGNABILITY_SOURCE_DIR) / "maps/sensors";
  for (const auto& entry : std::filesystem::directory_iterator(sensors)) {
    const SensorRig rig = read_sensor_rig(entry.path());
    EXPECT_EQ(rig.is_planar(), entry.path().filename().string().starts_with("s300")) << entry.path();
  }
}

TEST(SensorRig, SeesAllAroundOrDoesNot) {
  const std::filesystem::path sensors = std::filesystem::path(ALIGNABILITY_SOURCE_DIR) / "maps/sensors";
  for (const char* name : {"hdl32e.yaml", "os1-64.yaml", "vlp16.yaml", "s300-corners.yaml"}) {
    EXPECT_TRUE(read_sensor_rig(sensors / name).sees_all_around()) << name;
  }
  for (const char* name : {"hap.yaml", "s300.yaml"}) EXPECT_FALSE(read_sensor_rig(sensors / name).sees_all_around()) << name;
}

TEST(SensorRig, ThatLeansSeesAllAroundStill) {
  SensorRig rig = test::small_lidar();
  rig.lidars.front().T_base_lidar.rotate(Eigen::AngleAxisd(0.4, Eigen::Vector3d(1.0, 2.0, 0.0).normalized()));
  EXPECT_TRUE(rig.sees_all_around());
  rig.lidars.front().sectors.front().max = 1.5;
  EXPECT_FALSE(rig.sees_all_around());
}

}  // namespace
}  // namespace alignability
