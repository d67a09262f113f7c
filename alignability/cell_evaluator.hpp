// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "alignability/build_map.hpp"
#include "alignability/cell_summary.hpp"

namespace alignability::detail {

/// Evaluates cells, each independent of the rest. Safe to call from many threads, each with its own scorer.
class CellEvaluator {
 public:
  /// All three must outlive it.
  CellEvaluator(const Scene& scene, const SensorRig& sensor, const MapOptions& options)
      : scene_(scene), sensor_(sensor), options_(options) {}

  /// Throws Interrupted.
  CellValue operator()(const FreePart& free, std::size_t cell, Scorer& scorer) const;

 private:
  std::optional<Eigen::Isometry3d> robot_pose(const FreePart& free, std::size_t cell, int sample, const Eigen::Matrix3d& R_map_base) const;
  std::vector<Alignability> scores_at(int heading, const FreePart& free, std::size_t cell, Scorer& scorer) const;
  bool is_free(const Eigen::Isometry3d& T_map_base) const;

  const Scene& scene_;
  const SensorRig& sensor_;
  const MapOptions& options_;
};

}  // namespace alignability::detail
