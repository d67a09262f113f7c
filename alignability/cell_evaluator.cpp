// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/cell_evaluator.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <random>

#include "core/distribution.hpp"
#include "lidar/simulate_scan.hpp"

namespace alignability::detail {
namespace {

constexpr int kMostDraws = 20;

CellValue summary(std::vector<Alignability> scores, const Eigen::Matrix3d& R_map_lidar) {
  CellValue value;
  value.samples = static_cast<float>(scores.size());
  if (scores.empty()) return value;
  std::vector<double> alphas;
  Eigen::Matrix3d directions = Eigen::Matrix3d::Zero();
  for (const Alignability& score : scores) {
    alphas.push_back(score.alpha);
    const Eigen::Vector3d weakest = R_map_lidar * score.weakest_direction;
    directions += weakest * weakest.transpose();
  }
  std::ranges::sort(alphas);
  value.alpha = static_cast<float>(quantile(alphas, 0.5));
  value.iqr = static_cast<float>(quantile(alphas, 0.75) - quantile(alphas, 0.25));
  if (directions.trace() > 0.0) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(directions);
    value.weakest = solver.eigenvectors().col(2).cast<float>();
    Eigen::Index largest = 0;
    value.weakest.cwiseAbs().maxCoeff(&largest);
    if (value.weakest[largest] < 0.0f) value.weakest = -value.weakest;
  }
  return value;
}

}  // namespace

CellValue CellEvaluator::operator()(const FreePart& free, std::size_t cell, Scorer& scorer) const {
  std::vector<Alignability> scores;
  for (int sample = 0; sample < options_.samples; ++sample) {
    if (options_.stop.stop_requested()) throw Interrupted();
    if (const auto pose = sensor_pose(free, cell, sample)) {
      const NoiseKey noise{options_.seed, cell, static_cast<std::uint64_t>(sample)};
      const Scan scan = simulate_scan(scene_, lidar_, *pose, {.range_max = options_.range_max}, noise);
      scores.push_back(scorer.alignability(scan));
    }
  }
  return summary(std::move(scores), lidar_.T_base_lidar.linear());
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
