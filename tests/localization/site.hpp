// SPDX-License-Identifier: BSD-3-Clause
// Sites to drive in, simulated, and the maps that noiseless scans all over them make.
#pragma once

#include <cstdint>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "lidar/thinning.hpp"
#include "localization/ndt_mcl.hpp"
#include "localization/plane_map.hpp"
#include "tests/alignability/simulated.hpp"

namespace alignability::test {

// Coarse enough to be quick, with the mount and the noise of a real one.
inline LidarModel coarse_lidar() {
  LidarModel model = hdl32e();
  model.sectors.front().columns = 720;
  return model;
}

// Its maps are of surfaces as they are seen, not of walls' far sides.
struct Site {
  Site(std::vector<TriangleMesh> meshes, const std::vector<Pose2>& surveyed, LidarModel lidar = coarse_lidar())
      : scene(std::move(meshes)), model(std::move(lidar)) {
    std::vector<Eigen::Vector3f> points;
    for (const Pose2& pose : surveyed) {
      const Eigen::Isometry3f T = T_map_base(pose).cast<float>();
      for (const Eigen::Vector3f& point : points_from(pose, std::nullopt)) points.push_back(T * point);
    }
    ndt = std::make_shared<const Ndt>(points, NdtOptions{});
    planes = std::make_shared<const PlaneMap>(thinned(points, 0.05), PlaneMapOptions{});
  }

  static Eigen::Isometry3d T_map_base(const Pose2& pose) {
    return Eigen::Translation3d(pose.x, pose.y, 0.0) * Eigen::AngleAxisd(pose.yaw, Eigen::Vector3d::UnitZ());
  }

  // In the frame of base_link.
  std::vector<Eigen::Vector3f> points_from(const Pose2& pose, std::optional<NoiseKey> noise) const {
    Scan scan = simulate_scan(scene, model, T_map_base(pose) * model.T_base_lidar, {.range_max = 6.5}, noise);
    const Eigen::Isometry3f T_base_lidar = model.T_base_lidar.cast<float>();
    for (Eigen::Vector3f& point : scan.points) point = T_base_lidar * point;
    return scan.points;
  }

  std::vector<Eigen::Vector3f> seen_from(const Pose2& pose, std::uint64_t number) const {
    return points_from(pose, NoiseKey{.seed = 1, .cell = number, .sample = 0});
  }

  Scene scene;
  LidarModel model;
  std::shared_ptr<const Ndt> ndt;
  std::shared_ptr<const PlaneMap> planes;
};

// 12 × 8 m with a block to drive around, and two smaller things.
inline Site rich_site(LidarModel lidar = coarse_lidar()) {
  std::vector<Pose2> surveyed;
  for (const double x : {1.0, 4.0, 8.0, 11.0}) {
    for (const double y : {1.5, 5.5, 7.5}) surveyed.push_back({x, y, 0.0});
  }
  return {{box({-1.0, -1.0, -0.1}, {13.0, 9.0, 0.0}), box({-0.2, 0.0, 0.0}, {0.0, 8.0, 3.0}), box({12.0, 0.0, 0.0}, {12.2, 8.0, 3.0}),
           box({0.0, -0.2, 0.0}, {12.0, 0.0, 3.0}), box({0.0, 8.0, 0.0}, {12.0, 8.2, 3.0}), box({5.0, 3.5, 0.0}, {7.0, 4.5, 2.5}),
           box({2.0, 6.5, 0.0}, {3.0, 7.0, 2.0}), box({9.0, 0.5, 0.0}, {9.5, 1.5, 2.0})},
          surveyed,
          std::move(lidar)};
}

// 3 m wide and plain, its ends out of sight of −2 … 32 m.
inline Site plain_site() {
  std::vector<Pose2> surveyed;
  for (int x = -10; x < 40; ++x) surveyed.push_back({static_cast<double>(x), 0.0, 0.0});
  return {
      {box({-40.0, -2.0, -0.1}, {80.0, 2.0, 0.0}), box({-40.0, 1.5, 0.0}, {80.0, 1.7, 3.0}), box({-40.0, -1.7, 0.0}, {80.0, -1.5, 3.0})},
      surveyed};
}

// Of a drive around the rich site's block, at 1 m/s and 10 Hz: 4 m ahead, half a turn of 2 m radius, and again.
inline constexpr Pose2 kRoundStart{4.0, 2.0, 0.0};
inline Pose2 motion_around(std::uint64_t step) { return {0.1, 0.0, step % 103 < 40 ? 0.0 : std::numbers::pi / 63.0}; }

inline double distance(const Pose2& a, const Pose2& b) { return (a.position() - b.position()).norm(); }

}  // namespace alignability::test
