// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "alignability/build_map.hpp"

namespace alignability::detail {

/// What a map says of a cell, layer by layer; NaN where there is nothing to say.
using CellValue = std::vector<float>;

/// The layers of a map made with such options: alpha, samples, iqr, weak_x, weak_y, weak_z, then those of the readings.
std::vector<std::string> layer_names(const AlignabilityOptions& options);

/// Evaluates cells, each independent of the rest. Safe to call from many threads, each with its own scorer.
class CellEvaluator {
 public:
  /// All three must outlive it.
  CellEvaluator(const Scene& scene, const LidarModel& lidar, const MapOptions& options) : scene_(scene), lidar_(lidar), options_(options) {}

  /// Throws Interrupted.
  CellValue operator()(const FreePart& free, std::size_t cell, Scorer& scorer) const;

 private:
  std::optional<Eigen::Isometry3d> sensor_pose(const FreePart& free, std::size_t cell, int sample) const;

  const Scene& scene_;
  const LidarModel& lidar_;
  const MapOptions& options_;
};

}  // namespace alignability::detail
