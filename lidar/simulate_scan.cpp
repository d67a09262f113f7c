// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/simulate_scan.hpp"

#include <algorithm>
#include <boost/random/normal_distribution.hpp>
#include <initializer_list>
#include <limits>
#include <random>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/range.hpp"

namespace alignability {
namespace {

// How far beyond the range limit a surface can stand and noise still bring its return within: farther has a chance below 1e-15 a beam.
constexpr double kNoiseReach = 8.0;

std::mt19937_64 engine_of(const NoiseKey& key) {
  std::vector<std::uint32_t> words;
  const auto add = [&words](std::uint64_t word) {
    words.push_back(static_cast<std::uint32_t>(word));
    words.push_back(static_cast<std::uint32_t>(word >> 32));
  };
  for (const std::uint64_t word : {key.seed, key.cell, key.sample}) add(word);
  if (key.lidar > 0) add(key.lidar);  // the first has the numbers that it would have alone
  std::seed_seq sequence(words.begin(), words.end());
  return std::mt19937_64(sequence);
}

void add_noise(std::vector<float>& ranges, double stddev, const NoiseKey& key) {
  std::mt19937_64 engine = engine_of(key);
  // Boost's, because the standard leaves open which numbers std::normal_distribution draws.
  boost::random::normal_distribution<double> noise(0.0, stddev);
  for (float& range : ranges) range = static_cast<float>(range + noise(engine));
}

std::vector<ScanPart> parts_of(const SensorRig& rig) {
  std::vector<ScanPart> parts;
  std::size_t begin = 0;
  for (const LidarModel& lidar : rig.lidars) {
    parts.push_back({.begin = begin, .rings = lidar.rings(), .columns = lidar.columns(), .T_scan_lidar = lidar.T_base_lidar});
    begin += parts.back().size();
  }
  return parts;
}

}  // namespace

Scan simulate_scan(const Scene& scene, const LidarModel& model, const Eigen::Isometry3d& T_map_lidar, const ScanOptions& options,
                   std::optional<NoiseKey> noise) {
  if (!T_map_lidar.matrix().allFinite()) throw std::invalid_argument("a lidar must stand at a finite pose");
  const double range_max = std::min(model.range_max, options.range_max.value_or(model.range_max));
  if (options.range_max && !(*options.range_max > model.range_min)) {
    throw std::invalid_argument("range_max, " + to_text(*options.range_max) + " m, must be greater than the least range of " + model.name +
                                ", " + to_text(model.range_min) + " m");
  }
  const bool noisy = noise.has_value() && model.range_stddev > 0.0;

  const std::vector<Eigen::Vector3f> directions = beam_directions(model);
  const Eigen::Matrix3f R_map_lidar = T_map_lidar.linear().cast<float>();
  std::vector<Eigen::Vector3f> directions_in_map;
  directions_in_map.reserve(directions.size());
  for (const Eigen::Vector3f& direction : directions) directions_in_map.emplace_back(R_map_lidar * direction);

  const double reach = noisy ? range_max + kNoiseReach * model.range_stddev : range_max;
  std::vector<float> ranges = scene.cast(T_map_lidar.translation().cast<float>(), directions_in_map, static_cast<float>(reach));
  if (noisy) add_noise(ranges, model.range_stddev, *noise);

  Scan scan{.points = {}, .rings = model.rings(), .columns = model.columns()};
  scan.points.reserve(ranges.size());
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const bool seen = ranges[i] >= model.range_min && ranges[i] <= range_max;
    const float range = seen ? ranges[i] : std::numeric_limits<float>::quiet_NaN();
    scan.points.emplace_back(directions[i] * range);
  }
  return scan;
}

Scan simulate_rig_scan(const Scene& scene, const SensorRig& rig, const Eigen::Isometry3d& T_map_base, const ScanOptions& options,
                       std::optional<NoiseKey> noise) {
  if (rig.lidars.size() == 1) {
    return simulate_scan(scene, rig.lidars.front(), T_map_base * rig.lidars.front().T_base_lidar, options, noise);
  }
  Scan joined;
  joined.points.reserve(rig.beams());
  for (std::size_t i = 0; i < rig.lidars.size(); ++i) {
    const LidarModel& lidar = rig.lidars[i];
    if (noise) noise->lidar = i;
    const Scan scan = simulate_scan(scene, lidar, T_map_base * lidar.T_base_lidar, options, noise);
    const Eigen::Isometry3f T_base_lidar = lidar.T_base_lidar.cast<float>();
    for (const Eigen::Vector3f& point : scan.points) joined.points.emplace_back(T_base_lidar * point);
  }
  joined.columns = static_cast<int>(joined.points.size());
  joined.parts = parts_of(rig);
  return joined;
}

Scan told_apart(Scan scan, const SensorRig& rig) {
  if (rig.lidars.size() == 1) return scan;
  if (scan.points.size() != rig.beams()) {
    throw std::invalid_argument("has " + std::to_string(scan.points.size()) + " points where the sensor's " +
                                std::to_string(rig.lidars.size()) + " lidars have " + std::to_string(rig.beams()) + " beams");
  }
  scan.rings = 1;
  scan.columns = static_cast<int>(scan.points.size());
  scan.parts = parts_of(rig);
  for (std::size_t i = 0; i < scan.parts.size(); ++i) {
    const ScanPart& part = scan.parts[i];
    for (Eigen::Vector3f& point : std::span(scan.points).subspan(part.begin, part.size())) {
      const double range = (point.cast<double>() - part.T_scan_lidar.translation()).norm();
      if (!(range >= rig.lidars[i].range_min)) point.setConstant(std::numeric_limits<float>::quiet_NaN());
    }
  }
  return scan;
}

}  // namespace alignability
