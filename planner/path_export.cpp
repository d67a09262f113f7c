// SPDX-License-Identifier: BSD-3-Clause
#include "planner/path_export.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/range.hpp"

namespace alignability {

std::string to_nav_path(std::span<const Pose2> path) {
  const std::string header = "header: {stamp: {sec: 0, nanosec: 0}, frame_id: map}\n";
  std::string text = header + "poses:\n";
  for (const Pose2& pose : path) {
    text.append("- ").append(header);
    text.append("  pose: {position: {x: ").append(to_text(pose.x)).append(", y: ").append(to_text(pose.y));
    text.append(", z: 0}, orientation: {x: 0, y: 0, z: ").append(to_text(std::sin(pose.yaw / 2.0)));
    text.append(", w: ").append(to_text(std::cos(pose.yaw / 2.0))).append("}}\n");
  }
  return text;
}

std::string to_geojson(std::span<const Pose2> path, std::string_view name) {
  nlohmann::ordered_json line = nlohmann::ordered_json::array(), headings = line;
  for (const Pose2& pose : path) {
    line.push_back({pose.x, pose.y});
    headings.push_back(pose.yaw);
  }
  const nlohmann::ordered_json feature{{"type", "Feature"},
                                       {"properties", {{"name", name}, {"frame", "map"}, {"unit", "m"}, {"yaw", headings}}},
                                       {"geometry", {{"type", "LineString"}, {"coordinates", line}}}};
  return feature.dump(1) + '\n';
}

}  // namespace alignability
