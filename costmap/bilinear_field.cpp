// SPDX-License-Identifier: BSD-3-Clause
#include "costmap/bilinear_field.hpp"

#include <tuple>

namespace alignability {

double BilinearField::at(const Eigen::Vector2d& point) const {
  const GridGeometry& grid = nodes_.geometry();
  const Eigen::Array2d patch = ((point - grid.origin) / grid.resolution - Eigen::Vector2d::Constant(0.5)).array().floor();
  const auto clamped = [](double index, int nodes) { return index >= -1.0 ? static_cast<int>(std::min(index, nodes - 1.0)) : -1; };
  return in_patch({clamped(patch.x(), grid.width), clamped(patch.y(), grid.height)}, point);
}

double BilinearField::integral(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const {
  if (std::tie(to.x(), to.y()) < std::tie(from.x(), from.y())) return integral(to, from);
  double mean = 0.0;
  visit(from, to, [&](double share, const Quadratic& field) { mean += share * field.mean(); });
  return (to - from).norm() * mean;
}

}  // namespace alignability
