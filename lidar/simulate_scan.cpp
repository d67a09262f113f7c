// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/simulate_scan.hpp"

#include <algorithm>
#include <boost/random/normal_distribution.hpp>
#include <initializer_list>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

namespace alignability {
namespace {

// How far beyond the range limit a surface can stand and noise still bring its return within: farther has a chance below 1e-15 a beam.
constexpr double kNoiseReach = 8.0;

std::mt19937_64 engine_of(const NoiseKey& key) {
  std::vector<std::uint32_t> words;
  for (const std::uint64_t word : {key.seed, key.cell, key.sample}) {
    words.push_back(static_cast<std::uint32_t>(word));
    words.push_back(static_cast<std::uint32_t>(word >> 32));
  }
  std::seed_seq sequence(words.begin(), words.end());
  return std::mt19937_64(sequence);
}

void add_noise(std::vector<float>& ranges, double stddev, const NoiseKey& key) {
  std::mt19937_64 engine = engine_of(key);
  // Boost's, because the standard leaves open which numbers std::normal_distribution draws.
  boost::random::normal_distribution<double> noise(0.0, stddev);
  for (float& range : ranges) range = static_cast<float>(range + noise(engine));
}

}  // namespace

Scan simulate_scan(const Scene& scene, const LidarModel& model, const Eigen::Isometry3d& T_map_lidar, const ScanOptions& options,
                   std::optional<NoiseKey> noise) {
  if (!T_map_lidar.matrix().allFinite()) throw std::invalid_argument("a lidar must stand at a finite pose");
  const double range_max = std::min(model.range_max, options.range_max.value_or(model.range_max));
  const bool noisy = noise.has_value() && model.range_stddev > 0.0;

  const std::vector<Eigen::Vector3f> directions = beam_directions(model);
  const Eigen::Matrix3f R_map_lidar = T_map_lidar.linear().cast<float>();
  std::vector<Eigen::Vector3f> directions_in_map;
  directions_in_map.reserve(directions.size());
  for (const Eigen::Vector3f& direction : directions) directions_in_map.emplace_back(R_map_lidar * direction);

  const double reach = noisy ? range_max + kNoiseReach * model.range_stddev : range_max;
  std::vector<float> ranges = scene.cast(T_map_lidar.translation().cast<float>(), directions_in_map, static_cast<float>(reach));
  if (noisy) add_noise(ranges, model.range_stddev, *noise);

  Scan scan{.points = {}, .rings = model.rings(), .columns = model.columns};
  scan.points.reserve(ranges.size());
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const bool seen = ranges[i] >= model.range_min && ranges[i] <= range_max;
    const float range = seen ? ranges[i] : std::numeric_limits<float>::quiet_NaN();
    scan.points.emplace_back(directions[i] * range);
  }
  return scan;
}

}  // namespace alignability
