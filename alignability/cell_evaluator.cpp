// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/cell_evaluator.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>
#include <random>

#include "core/distribution.hpp"
#include "lidar/simulate_scan.hpp"

namespace alignability::detail {
namespace {

constexpr int kMostDraws = 20;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

template <typename Value>
std::vector<double> sorted(const std::vector<Alignability>& scores, Value value) {
  std::vector<double> values;
  for (const Alignability& score : scores) values.push_back(value(score));
  std::ranges::sort(values);
  return values;
}

// The line that lies closest to all the directions, whatever their signs: a unit vector whose largest part is positive; NaN without any.
template <int kSize, typename Direction>
Eigen::Vector<float, kSize> common_axis(const std::vector<Alignability>& scores, Direction direction) {
  Eigen::Matrix<double, kSize, kSize> sum = Eigen::Matrix<double, kSize, kSize>::Zero();
  for (const Alignability& score : scores) {
    const Eigen::Vector<double, kSize> along = direction(score);
    sum += along * along.transpose();
  }
  if (!(sum.trace() > 0.0)) return Eigen::Vector<float, kSize>::Constant(kNan);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, kSize, kSize>> solver(sum);
  Eigen::Vector<float, kSize> axis = solver.eigenvectors().col(kSize - 1).template cast<float>();
  Eigen::Index largest = 0;
  axis.cwiseAbs().maxCoeff(&largest);
  return axis[largest] < 0.0f ? Eigen::Vector<float, kSize>(-axis) : axis;
}

void append(CellValue& values, const Eigen::Ref<const Eigen::VectorXf>& more) { values.insert(values.end(), more.begin(), more.end()); }

CellValue summary(const std::vector<Alignability>& scores, const Eigen::Matrix3d& R_map_lidar, const AlignabilityOptions& options) {
  if (scores.empty()) {
    CellValue nothing(layer_names(options).size(), kNan);
    nothing[1] = 0.0f;
    return nothing;
  }
  const auto median = [&](auto value) { return static_cast<float>(quantile(sorted(scores, value), 0.5)); };
  const std::vector<double> alphas = sorted(scores, [](const Alignability& score) { return score.alpha; });
  CellValue values{static_cast<float>(quantile(alphas, 0.5)), static_cast<float>(scores.size()),
                   static_cast<float>(quantile(alphas, 0.75) - quantile(alphas, 0.25))};
  append(values, common_axis<3>(scores, [&](const Alignability& score) { return R_map_lidar * score.weakest_direction; }));
  for (const Reading reading : options.readings) {
    values.push_back(median([&](const Alignability& score) { return value_of(reading, score.readings); }));
    if (reading != Reading::information) continue;
    values.push_back(median([](const Alignability& score) { return score.readings.information.yaw; }));
    append(values, common_axis<2>(scores, [](const Alignability& score) { return score.readings.information.weakest_direction; }));
  }
  return values;
}

}  // namespace

std::vector<std::string> layer_names(const AlignabilityOptions& options) {
  std::vector<std::string> names{"alpha", "samples", "iqr", "weak_x", "weak_y", "weak_z"};
  for (const Reading reading : options.readings) {
    names.emplace_back(to_string(reading));
    if (reading == Reading::information) names.insert(names.end(), {"information_yaw", "information_x", "information_y"});
  }
  return names;
}

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
  return summary(scores, lidar_.T_base_lidar.linear(), options_.alignability);
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
