// SPDX-License-Identifier: BSD-3-Clause
#include "localization/survey.hpp"

#include <algorithm>
#include <span>
#include <stdexcept>

#include "core/range.hpp"
#include "lidar/in_parallel.hpp"
#include "lidar/simulate_scan.hpp"
#include "localization/cube_index.hpp"

namespace alignability {
namespace {

// So many are held before they are thinned: it does not grow with their number.
constexpr std::size_t kScansAtOnce = 32;

// The mean of the points in each cube, in the order in which the cubes were first met.
class ThinnedCloud {
 public:
  explicit ThinnedCloud(double side) : side_(side) {}

  void add(std::span<const Eigen::Vector3f> points, const Eigen::Isometry3f& T_map_points) {
    for (const Eigen::Vector3f& point : points) {
      if (!point.allFinite()) continue;
      const Eigen::Vector3d place = (T_map_points * point).cast<double>();
      const std::size_t number = index_.number(cube_of(place, side_));
      if (number == sums_.size()) sums_.push_back({Eigen::Vector3d::Zero(), 0.0});
      Sum& sum = sums_[number];
      sum.of_points += place;
      sum.count += 1.0;
    }
  }

  std::vector<Eigen::Vector3f> points() const {
    std::vector<Eigen::Vector3f> means;
    for (const Sum& sum : sums_) means.emplace_back((sum.of_points / sum.count).cast<float>());
    return means;
  }

 private:
  struct Sum {
    Eigen::Vector3d of_points;
    double count;
  };

  double side_;
  CubeIndex index_;
  std::vector<Sum> sums_;
};

// Poses of the robot.
std::vector<Eigen::Isometry3d> places(const Scene& scene, const OccupancyMap& occupancy, const SensorRig& sensor,
                                      const SurveyOptions& options) {
  const GridGeometry& grid = occupancy.geometry();
  std::vector<Eigen::Isometry3d> poses;
  for (double y = grid.origin.y() + 0.5 * options.spacing; y < grid.upper_corner().y(); y += options.spacing) {
    for (double x = grid.origin.x() + 0.5 * options.spacing; x < grid.upper_corner().x(); x += options.spacing) {
      const auto cell = grid.cell_near({x, y});
      if (!cell || !occupancy.is_free(*cell)) continue;
      const Eigen::Isometry3d T_map_base(Eigen::Translation3d(x, y, options.floor));
      const auto is_free = [&](const LidarModel& lidar) {
        return scene.is_free((T_map_base * lidar.T_base_lidar).translation().cast<float>(), kSensorClearance);
      };
      if (std::ranges::all_of(sensor.lidars, is_free)) poses.push_back(T_map_base);
    }
  }
  return poses;
}

Eigen::Isometry3f above_floor(Eigen::Isometry3d T_map_scan, double floor) {
  T_map_scan.translation().z() -= floor;
  return T_map_scan.cast<float>();
}

}  // namespace

std::vector<Eigen::Vector3f> survey(const Scene& scene, const OccupancyMap& occupancy, const SensorRig& sensor,
                                    const SurveyOptions& options) {
  for (const double length : {options.spacing, options.thinning}) {
    if (!kPositive.contains(length)) throw std::invalid_argument("the spacing and the thinning of a survey must be greater than 0");
  }
  const std::vector<Eigen::Isometry3d> poses = places(scene, occupancy, sensor, options);
  ThinnedCloud cloud(options.thinning);
  for (std::size_t begin = 0; begin < poses.size(); begin += kScansAtOnce) {
    if (options.stop.stop_requested()) throw Interrupted();
    std::vector<Scan> scans(std::min(kScansAtOnce, poses.size() - begin));
    in_parallel(scans.size(), options.threads,
                [&](std::size_t i) { scans[i] = simulate_rig_scan(scene, sensor, poses[begin + i], {.range_max = options.range_max}); });
    for (std::size_t i = 0; i < scans.size(); ++i) {
      cloud.add(scans[i].points, above_floor(poses[begin + i] * sensor.T_base_scan(), options.floor));
    }
    if (options.progress) options.progress({begin + scans.size(), poses.size()});
  }
  return cloud.points();
}

}  // namespace alignability
