// SPDX-License-Identifier: BSD-3-Clause
#include "localization/drive.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/progress.hpp"
#include "core/range.hpp"
#include "lidar/simulate_scan.hpp"

namespace alignability {
namespace {

Eigen::Isometry3d T_map_base(const Pose2& pose, double floor) {
  return Eigen::Translation3d(pose.x, pose.y, floor) * Eigen::AngleAxisd(pose.yaw, Eigen::Vector3d::UnitZ());
}

// From the frame of one pose to the other.
Pose2 motion_between(const Pose2& from, const Pose2& to) {
  const double c = std::cos(from.yaw), s = std::sin(from.yaw);
  const Eigen::Vector2d apart = to.position() - from.position();
  return {c * apart.x() + s * apart.y(), -s * apart.x() + c * apart.y(), normalized_angle(to.yaw - from.yaw)};
}

std::vector<Eigen::Vector3f> in_base(const Scan& scan, const Eigen::Isometry3d& T_base_lidar) {
  const Eigen::Isometry3f T = T_base_lidar.cast<float>();
  std::vector<Eigen::Vector3f> points;
  for (const Eigen::Vector3f& point : scan.points) {
    if (point.allFinite()) points.push_back(T * point);
  }
  return points;
}

}  // namespace

std::vector<TimedPose> poses_along(std::span<const Pose2> path, const Pace& pace, double period) {
  for (const double value : {pace.speed, pace.turn_rate, period}) {
    if (!kPositive.contains(value)) throw std::invalid_argument("a pace and a period must be greater than 0");
  }
  std::vector<TimedPose> poses;
  if (path.empty()) return poses;
  double begin = 0.0;  // of the piece [s]
  double s = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double length = (path[i].position() - path[i - 1].position()).norm();
    const double turned = std::abs(normalized_angle(path[i].yaw - path[i - 1].yaw));
    const double lasts = std::max(length / pace.speed, turned / pace.turn_rate);
    for (double at = period * static_cast<double>(poses.size()); at < begin + lasts; at = period * static_cast<double>(poses.size())) {
      const double share = (at - begin) / lasts;
      poses.push_back({at, s + share * length, between(path[i - 1], path[i], share)});
    }
    begin += lasts;
    s += length;
  }
  poses.push_back({begin, s, path.back()});
  return poses;
}

std::vector<DriveSample> drive(const Scene& scene, const LidarModel& lidar, std::shared_ptr<const Ndt> map, std::span<const Pose2> path,
                               const DriveOptions& options) {
  const std::vector<TimedPose> poses = poses_along(path, options.pace, 1.0 / lidar.rate);
  std::vector<DriveSample> samples;
  if (poses.empty()) return samples;
  Odometry odometry(options.odometry, options.seed);
  NdtMcl filter(std::move(map), path.front(), options.start_deviations, options.filter, options.seed);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (options.stop.stop_requested()) throw Interrupted();
    if (i > 0) filter.move(odometry.report(motion_between(poses[i - 1].pose, poses[i].pose)));
    const NoiseKey noise{.seed = options.seed, .cell = i, .sample = 0};
    const Eigen::Isometry3d T_map_lidar = T_map_base(poses[i].pose, options.floor) * lidar.T_base_lidar;
    const Scan scan = simulate_scan(scene, lidar, T_map_lidar, {.range_max = options.range_max}, noise);
    filter.see(Ndt(in_base(scan, lidar.T_base_lidar), options.ndt));
    samples.push_back({poses[i], filter.estimate()});
  }
  return samples;
}

}  // namespace alignability
