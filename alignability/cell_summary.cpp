// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/cell_summary.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/distribution.hpp"
#include "costmap/heading_layers.hpp"

namespace alignability::detail {
namespace {

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

}  // namespace

std::vector<std::string> layer_names(const AlignabilityOptions& options, int headings) {
  std::vector<std::string> names{"alpha", "samples", "iqr", "weak_x", "weak_y", "weak_z"};
  for (const Reading reading : options.readings) {
    names.emplace_back(to_string(reading));
    if (reading == Reading::information) names.insert(names.end(), {"information_yaw", "information_x", "information_y"});
  }
  for (int heading = 0; headings > 1 && heading < headings; ++heading) {
    names.push_back(heading_layer_name(static_cast<std::size_t>(heading)));
  }
  return names;
}

Alignability in_map(Alignability score, const Eigen::Matrix3d& R_map_base, const Eigen::Matrix3d& R_base_scan) {
  score.weakest_direction = R_map_base * R_base_scan * score.weakest_direction;
  Eigen::Vector2d& along = score.readings.information.weakest_direction;
  along = (R_map_base * Eigen::Vector3d(along.x(), along.y(), 0.0)).head<2>().eval();
  return score;
}

CellValue summary(const std::vector<Alignability>& scores, const AlignabilityOptions& options) {
  if (scores.empty()) {
    CellValue nothing(layer_names(options).size(), kNan);
    nothing[1] = 0.0f;
    return nothing;
  }
  const auto median = [&](auto value) { return static_cast<float>(quantile(sorted(scores, value), 0.5)); };
  const std::vector<double> alphas = sorted(scores, [](const Alignability& score) { return score.alpha; });
  CellValue values{static_cast<float>(quantile(alphas, 0.5)), static_cast<float>(scores.size()),
                   static_cast<float>(quantile(alphas, 0.75) - quantile(alphas, 0.25))};
  append(values, common_axis<3>(scores, [](const Alignability& score) { return score.weakest_direction; }));
  for (const Reading reading : options.readings) {
    values.push_back(median([&](const Alignability& score) { return value_of(reading, score.readings); }));
    if (reading != Reading::information) continue;
    values.push_back(median([](const Alignability& score) { return score.readings.information.yaw; }));
    append(values, common_axis<2>(scores, [](const Alignability& score) { return score.readings.information.weakest_direction; }));
  }
  return values;
}

CellValue summary(const std::vector<std::vector<Alignability>>& scores_by_heading, const AlignabilityOptions& options) {
  std::vector<CellValue> by_heading;
  for (const std::vector<Alignability>& scores : scores_by_heading) by_heading.push_back(summary(scores, options));
  const auto alpha = [](const CellValue& value) { return value.front(); };
  const auto is_lower = [](float a, float b) { return a < b || (!std::isnan(a) && std::isnan(b)); };
  CellValue values = *std::ranges::min_element(by_heading, is_lower, alpha);
  if (by_heading.size() > 1) {
    for (const CellValue& value : by_heading) values.push_back(alpha(value));
  }
  return values;
}

}  // namespace alignability::detail
