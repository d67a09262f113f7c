// SPDX-License-Identifier: BSD-3-Clause
#include "planner/path_export.hpp"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <nlohmann/json.hpp>
#include <numbers>
#include <vector>

namespace alignability {
namespace {

const std::vector<Pose2> kPath{{1.0, 2.0, 0.0}, {3.5, -4.25, std::numbers::pi / 2.0}};

TEST(PathExport, NavPathHoldsPosesInMap) {
  const YAML::Node path = YAML::Load(to_nav_path(kPath));
  EXPECT_EQ(path["header"]["frame_id"].as<std::string>(), "map");
  ASSERT_EQ(path["poses"].size(), 2u);
  EXPECT_EQ(path["poses"][0]["header"]["frame_id"].as<std::string>(), "map");
  const YAML::Node pose = path["poses"][1]["pose"];
  EXPECT_EQ(pose["position"]["x"].as<double>(), 3.5);
  EXPECT_EQ(pose["position"]["y"].as<double>(), -4.25);
  EXPECT_DOUBLE_EQ(pose["orientation"]["z"].as<double>(), std::sin(std::numbers::pi / 4.0));
  EXPECT_DOUBLE_EQ(pose["orientation"]["w"].as<double>(), std::cos(std::numbers::pi / 4.0));
}

TEST(PathExport, GeoJsonIsALineInMetresOfMap) {
  const nlohmann::json feature = nlohmann::json::parse(to_geojson(kPath, "safe"));
  EXPECT_EQ(feature["type"], "Feature");
  EXPECT_EQ(feature["geometry"]["type"], "LineString");
  EXPECT_EQ(feature["geometry"]["coordinates"], nlohmann::json({{1.0, 2.0}, {3.5, -4.25}}));
  EXPECT_EQ(feature["properties"]["name"], "safe");
  EXPECT_EQ(feature["properties"]["yaw"], nlohmann::json({0.0, std::numbers::pi / 2.0}));
}

}  // namespace
}  // namespace alignability
