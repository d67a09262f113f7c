// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/cell_evaluator.hpp"

#include <random>

#include "lidar/simulate_scan.hpp"

namespace alignability::detail {
namespace {

constexpr int kMostDraws = 20;

}  // namespace

CellValue CellEvaluator::operator()(const FreePart& free, std::size_t cell, Scorer& scorer) const {
  std::vector<Alignability> scores;
  for (int sample = 0; sample < options_.samples; ++sample) {
    if (options_.stop.stop_requested()) throw Interrupted();
    if (const auto pose = sensor_pose(free, cell, sample)) {
      const NoiseKey noise{options_.seed, cell, static_cast<std::uint64_t>(sample)};
      const Scan scan = simulate_scan(scene_, lidar_, *pose, {.range_max = options_.range_max}, noise);
      scores.push_back(in_map(scorer.alignability(scan), Eigen::Matrix3d::Identity(), lidar_.T_base_lidar.linear()));
    }
  }
  return summary(scores, options_.alignability);
}

std::optional<Eigen::Isometry3d> CellEvaluator::sensor_pose(const FreePart& free, std::size_t cell, int sample) const {
  const auto word = [](std::uint64_t value, int half) { return static_cast<std::uint32_t>(value >> (32 * half)); };
  constexpr std::uint32_t kPlaces = 0x706c6163;  // apart from the noise, which is keyed by the same numbers
  std::seed_seq key{
      word(options_.seed, 0), word(options_.seed, 1), word(cell, 0), word(cell, 1), static_cast<std::uint32_t>(sample), kPlaces};
  std::mt19937_64 engine(key);
  const auto uniform = [&engine] { return static_cast<double>(engine() >> 11) * 0x1p-53; };
  for (int draw = 0; draw < kMostDraws; ++draw) {
    const double share = (sample + uniform()) / options_.samples;
    const double u = uniform();
    const double v = uniform();
    Eigen::Isometry3d T_map_base = Eigen::Isometry3d::Identity();
    T_map_base.translation() << free.at(share, u, v), options_.floor;
    const Eigen::Isometry3d T_map_lidar = T_map_base * lidar_.T_base_lidar;
    if (scene_.is_free(T_map_lidar.translation().cast<float>(), kSensorClearance)) return T_map_lidar;
  }
  return std::nullopt;
}

}  // namespace alignability::detail
