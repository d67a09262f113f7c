// SPDX-License-Identifier: BSD-3-Clause
#include "localization/ndt.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <stdexcept>

#include "core/range.hpp"

namespace alignability {
namespace {

// Sums about the first point of the cell, whose coordinates may be large.
struct Sums {
  Eigen::Vector3d center;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  int count = 0;
};

Eigen::Matrix3d with_least_width(const Eigen::Matrix3d& covariance, double flattest) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  const Eigen::Vector3d widths = solver.eigenvalues().cwiseMax(flattest * solver.eigenvalues()[2]);
  return solver.eigenvectors() * widths.asDiagonal() * solver.eigenvectors().transpose();
}

}  // namespace

Ndt::Ndt(std::span<const Eigen::Vector3f> points, const NdtOptions& options) : cell_(options.cell) {
  if (!kPositive.contains(options.cell)) throw std::invalid_argument("the side of a cell must be greater than 0");
  if (options.min_points < 4) throw std::invalid_argument("a cell needs at least 4 points");
  if (!kPositive.contains(options.flattest) || options.flattest > 1.0) throw std::invalid_argument("flattest must be in (0, 1]");
  std::unordered_map<Cube, std::size_t, CubeHash> numbers;
  std::vector<std::pair<Cube, Sums>> all;
  for (const Eigen::Vector3f& point : points) {
    if (!point.allFinite()) continue;
    const Eigen::Vector3d place = point.cast<double>();
    const Cube cube = cube_of(place, cell_);
    const auto [found, is_new] = numbers.try_emplace(cube, all.size());
    if (is_new) all.push_back({cube, {.center = place}});
    Sums& sums = all[found->second].second;
    const Eigen::Vector3d offset = place - sums.center;
    sums.first += offset;
    sums.second += offset * offset.transpose();
    ++sums.count;
  }
  for (const auto& [cube, sums] : all) {
    if (sums.count < options.min_points) continue;
    const Eigen::Vector3d mean = sums.first / sums.count;
    const Eigen::Matrix3d covariance = (sums.second - sums.count * mean * mean.transpose()) / (sums.count - 1);
    if (!(covariance.trace() > 0.0)) continue;
    index_.emplace(cube, static_cast<std::int32_t>(cells_.size()));
    cells_.push_back({sums.center + mean, with_least_width(covariance, options.flattest)});
  }
}

const NdtCell* Ndt::find(const Eigen::Vector3d& place) const {
  if (!place.allFinite()) return nullptr;
  const auto found = index_.find(cube_of(place, cell_));
  return found == index_.end() ? nullptr : &cells_[static_cast<std::size_t>(found->second)];
}

}  // namespace alignability
