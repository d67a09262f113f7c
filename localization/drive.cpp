// SPDX-License-Identifier: BSD-3-Clause
#include "localization/drive.hpp"

#include <algorithm>
#include <boost/random/normal_distribution.hpp>
#include <cmath>
#include <random>
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

std::vector<Eigen::Vector3f> in_base(const Scan& scan, const Eigen::Isometry3d& T_base_scan) {
  const Eigen::Isometry3f T = T_base_scan.cast<float>();
  std::vector<Eigen::Vector3f> points;
  for (const Eigen::Vector3f& point : scan.points) {
    if (point.allFinite()) points.push_back(T * point);
  }
  return points;
}

// What a drive draws at random, each from numbers of its own.
enum class Part : std::uint64_t { odometry = 1, start, localizer, ranges };

// SplitMix64 (Steele, Lea and Flood 2014).
std::uint64_t seed_of(std::uint64_t seed, Part part) {
  std::uint64_t mixed = seed + static_cast<std::uint64_t>(part) * 0x9e3779b97f4a7c15U;
  mixed = (mixed ^ mixed >> 30) * 0xbf58476d1ce4e5b9U;
  mixed = (mixed ^ mixed >> 27) * 0x94d049bb133111ebU;
  return mixed ^ mixed >> 31;
}

Pose2 off_by(const Pose2& pose, const Pose2& deviations, std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  boost::random::normal_distribution<double> normal;
  const double x = deviations.x * normal(engine);
  const double y = deviations.y * normal(engine);
  return {pose.x + x, pose.y + y, normalized_angle(pose.yaw + deviations.yaw * normal(engine))};
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

Drive drive(const Scene& scene, const SensorRig& sensor, const LocalizationMap& map, std::span<const Pose2> path,
            const DriveOptions& options, std::uint64_t seed, std::stop_token stop) {
  const std::vector<TimedPose> poses = poses_along(path, options.pace, 1.0 / sensor.rate());
  Drive samples;
  if (poses.empty()) return samples;
  const LocalizerOptions localizer_options = for_sensor(options.localizer, sensor);
  Odometry odometry(options.odometry, seed_of(seed, Part::odometry));
  std::vector<RunningLocalizer> localizers;
  const Pose2 start = off_by(path.front(), options.localizer.start_deviations, seed_of(seed, Part::start));
  for (const Localizer localizer : options.localizers) {
    localizers.emplace_back(localizer, map, start, localizer_options, seed_of(seed, Part::localizer));
  }
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (stop.stop_requested()) throw Interrupted();
    const Pose2 motion = i > 0 ? odometry.report(motion_between(poses[i - 1].pose, poses[i].pose)) : Pose2{};
    const NoiseKey noise{.seed = seed_of(seed, Part::ranges), .cell = i, .sample = 0};
    const Scan scan = simulate_rig_scan(scene, sensor, T_map_base(poses[i].pose, options.floor), {.range_max = options.range_max}, noise);
    const std::vector<Eigen::Vector3f> points = in_base(scan, sensor.T_base_scan());
    const Ndt ndt(points, localizer_options.ndt);
    DriveSample sample{poses[i], {}};
    for (RunningLocalizer& localizer : localizers) {
      localizer.move(motion);
      localizer.see(points, ndt);
      sample.estimates.push_back(localizer.estimate());
    }
    samples.push_back(std::move(sample));
  }
  return samples;
}

}  // namespace alignability
