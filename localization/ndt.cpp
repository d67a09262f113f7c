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

Ndt::Ndt(std::span<const Eigen::Vector3f> points, const NdtOptions& options) : shape_(options.shape), cell_(options.cell) {
  if (!kPositive.contains(options.cell)) throw std::invalid_argument("the side of a cell must be greater than 0");
  if (options.min_points < 4) throw std::invalid_argument("a cell needs at least 4 points");
  if (!kPositive.contains(options.flattest) || options.flattest > 1.0) throw std::invalid_argument("flattest must be in (0, 1]");
  CubeIndex numbers;
  std::vector<std::pair<Cube, Sums>> all;
  std::size_t last = 0;
  for (const Eigen::Vector3f& point : points) {
    if (!point.allFinite()) continue;
    const Eigen::Vector3d place = counted(point.cast<double>());
    const Cube cube = cube_of(place, cell_);
    if (all.empty() || cube != all[last].first) last = numbers.number(cube);  // a scan's next point is often in the same cell
    if (last == all.size()) all.push_back({cube, {.center = place}});
    Sums& sums = all[last].second;
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
    index_.number(cube);  // that of the cell
    cells_.push_back({sums.center + mean, with_least_width(covariance, options.flattest)});
  }
}

Eigen::Vector3d Ndt::counted(const Eigen::Vector3d& place) const {
  return shape_ == NdtCells::squares ? Eigen::Vector3d(place.x(), place.y(), 0.0) : place;
}

const NdtCell* Ndt::find(const Eigen::Vector3d& place) const {
  if (!place.allFinite()) return nullptr;
  const auto number = index_.find(cube_of(counted(place), cell_));
  return number ? &cells_[*number] : nullptr;
}

}  // namespace alignability
