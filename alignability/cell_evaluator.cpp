// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/cell_evaluator.hpp"

#include <algorithm>
#include <numbers>
#include <random>

#include "lidar/simulate_scan.hpp"

namespace alignability::detail {
namespace {

constexpr int kMostDraws = 20;

}  // namespace

CellValue CellEvaluator::operator()(const FreePart& free, std::size_t cell, Scorer& scorer) const {
  std::vector<std::vector<Alignability>> scores_by_heading;
  for (int heading = 0; heading < options_.headings; ++heading) scores_by_heading.push_back(scores_at(heading, free, cell, scorer));
  return summary(scores_by_heading, options_.alignability);
}

// Of the same places at every heading, as far as the robot's lidars are free there; the noise is another at each.
std::vector<Alignability> CellEvaluator::scores_at(int heading, const FreePart& free, std::size_t cell, Scorer& scorer) const {
  const double yaw = 2.0 * std::numbers::pi * heading / options_.headings;
  const Eigen::Matrix3d R_map_base = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  std::vector<Alignability> scores;
  for (int sample = 0; sample < options_.samples; ++sample) {
    if (options_.stop.stop_requested()) throw Interrupted();
    if (const auto T_map_base = robot_pose(free, cell, sample, R_map_base)) {
      const NoiseKey noise{
          options_.seed, cell,
          static_cast<std::uint64_t>(heading) * static_cast<std::uint64_t>(options_.samples) + static_cast<std::uint64_t>(sample)};
      const Scan scan = simulate_rig_scan(scene_, sensor_, *T_map_base, {.range_max = options_.range_max}, noise);
      scores.push_back(in_map(scorer.alignability(scan), R_map_base, sensor_.T_base_scan().linear()));
    }
  }
  return scores;
}

std::optional<Eigen::Isometry3d> CellEvaluator::robot_pose(const FreePart& free, std::size_t cell, int sample,
                                                           const Eigen::Matrix3d& R_map_base) const {
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
    T_map_base.linear() = R_map_base;
    T_map_base.translation() << free.at(share, u, v), options_.floor;
    if (is_free(T_map_base)) return T_map_base;
  }
  return std::nullopt;
}

bool CellEvaluator::is_free(const Eigen::Isometry3d& T_map_base) const {
  return std::ranges::all_of(sensor_.lidars, [&](const LidarModel& lidar) {
    return scene_.is_free((T_map_base * lidar.T_base_lidar).translation().cast<float>(), kSensorClearance);
  });
}

}  // namespace alignability::detail
