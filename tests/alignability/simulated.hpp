// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "lidar/lidar_model.hpp"
#include "lidar/primitives.hpp"
#include "lidar/scene.hpp"
#include "lidar/simulate_scan.hpp"

namespace alignability::test {

inline TriangleMesh box(const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
  return transformed(make_box(high - low), Eigen::Affine3d(Eigen::Translation3d(0.5 * (low + high))));
}

inline std::vector<TriangleMesh> floor_and(std::vector<TriangleMesh> walls) {
  walls.push_back(box({-50.0, -50.0, -0.1}, {50.0, 50.0, 0.0}));
  return walls;
}

/// Walls 3 m apart along x, their ends out of sight.
inline std::vector<TriangleMesh> plain_corridor() {
  return floor_and({box({-60.0, 1.5, 0.0}, {60.0, 1.7, 5.0}), box({-60.0, -1.7, 0.0}, {60.0, -1.5, 5.0})});
}

inline LidarModel hdl32e() { return read_lidar_model(std::filesystem::path(ALIGNABILITY_SOURCE_DIR) / "maps/sensors/hdl32e.yaml"); }

/// What an HDL-32E sees from 1.9 m above the origin, cropped to 6.5 m.
inline Scan scan_of(std::vector<TriangleMesh> meshes, std::optional<NoiseKey> noise = std::nullopt) {
  Eigen::Isometry3d T_map_lidar = Eigen::Isometry3d::Identity();
  T_map_lidar.translation().z() = 1.9;
  return simulate_scan(Scene(std::move(meshes)), hdl32e(), T_map_lidar, {.range_max = 6.5}, noise);
}

}  // namespace alignability::test
