// SPDX-License-Identifier: BSD-3-Clause
#include "localization/survey.hpp"

#include <stdexcept>

#include "core/range.hpp"
#include "lidar/simulate_scan.hpp"
#include "lidar/thinning.hpp"

namespace alignability {
namespace {

constexpr float kSensorClearance = 0.1f;  // [m]
// Scans are joined, and thinned together, so many at a time: what is held does not grow with their number.
constexpr int kScansAtOnce = 32;

std::vector<Eigen::Isometry3d> places(const Scene& scene, const OccupancyMap& occupancy, const LidarModel& lidar,
                                      const SurveyOptions& options) {
  const GridGeometry& grid = occupancy.geometry();
  std::vector<Eigen::Isometry3d> poses;
  for (double y = grid.origin.y() + 0.5 * options.spacing; y < grid.upper_corner().y(); y += options.spacing) {
    for (double x = grid.origin.x() + 0.5 * options.spacing; x < grid.upper_corner().x(); x += options.spacing) {
      const auto cell = grid.cell_near({x, y});
      if (!cell || !occupancy.is_free(*cell)) continue;
      const Eigen::Isometry3d T_map_lidar = Eigen::Translation3d(x, y, options.floor) * lidar.T_base_lidar;
      if (scene.is_free(T_map_lidar.translation().cast<float>(), kSensorClearance)) poses.push_back(T_map_lidar);
    }
  }
  return poses;
}

}  // namespace

std::vector<Eigen::Vector3f> survey(const Scene& scene, const OccupancyMap& occupancy, const LidarModel& lidar,
                                    const SurveyOptions& options) {
  if (!kPositive.contains(options.spacing)) throw std::invalid_argument("the spacing of a survey must be greater than 0");
  std::vector<Eigen::Vector3f> cloud;
  std::vector<Eigen::Vector3f> fresh;
  const std::vector<Eigen::Isometry3d> poses = places(scene, occupancy, lidar, options);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (options.stop.stop_requested()) throw Interrupted();
    const Scan scan = simulate_scan(scene, lidar, poses[i], {.range_max = options.range_max});
    const Eigen::Isometry3f T_map_lidar = poses[i].cast<float>();
    for (const Eigen::Vector3f& point : scan.points) {
      if (point.allFinite()) fresh.push_back(T_map_lidar * point);
    }
    if ((i + 1) % kScansAtOnce == 0 || i + 1 == poses.size()) {
      fresh.insert(fresh.end(), cloud.begin(), cloud.end());
      cloud = thinned(fresh, options.thinning);
      fresh.clear();
    }
    if (options.progress) options.progress({i + 1, poses.size()});
  }
  return cloud;
}

}  // namespace alignability
