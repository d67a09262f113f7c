// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "costmap/grid.hpp"

namespace alignability::test {

inline Grid<double> random_field(std::mt19937_64& random, const GridGeometry& geometry) {
  std::uniform_real_distribution<double> uniform;
  Grid<double> nodes(geometry, 0.0);
  for (std::size_t i = 0; i < geometry.size(); ++i) nodes[i] = uniform(random);
  return nodes;
}

/// The bilinear field as a sum over all nodes, each times a tent; the point first brought between the outermost centres.
inline double reference_value(const Grid<double>& nodes, const Eigen::Vector2d& point) {
  const GridGeometry& geometry = nodes.geometry();
  const Eigen::Vector2d low = geometry.center({0, 0});
  const Eigen::Vector2d high = geometry.center({geometry.width - 1, geometry.height - 1});
  const Eigen::Vector2d inside(std::clamp(point.x(), low.x(), high.x()), std::clamp(point.y(), low.y(), high.y()));
  double sum = 0.0;
  for (std::size_t i = 0; i < geometry.size(); ++i) {
    const Eigen::Array2d away = ((inside - geometry.center(geometry.cell_of(i))) / geometry.resolution).array().abs();
    sum += nodes[i] * std::max(0.0, 1.0 - away.x()) * std::max(0.0, 1.0 - away.y());
  }
  return sum;
}

/// ∫ f ds by Gauss-Legendre with three nodes, exact for quintics, between all crossings with the lines through the centres.
inline double quadrature(const Grid<double>& nodes, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  const GridGeometry& geometry = nodes.geometry();
  std::vector<double> cuts{0.0, 1.0};
  for (int axis = 0; axis < 2; ++axis) {
    for (int k = 0; k < (axis == 0 ? geometry.width : geometry.height); ++k) {
      const double cut = (geometry.center({k, k})[axis] - from[axis]) / (to[axis] - from[axis]);
      if (cut > 0.0 && cut < 1.0) cuts.push_back(cut);
    }
  }
  std::sort(cuts.begin(), cuts.end());
  const double outer = std::sqrt(0.6);
  const std::array<std::array<double, 2>, 3> rule{{{-outer, 5.0 / 18.0}, {0.0, 8.0 / 18.0}, {outer, 5.0 / 18.0}}};
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const double half = 0.5 * (cuts[i + 1] - cuts[i]);
    for (const auto& [at, weight] : rule)
      sum += 2.0 * half * weight * reference_value(nodes, from + (cuts[i] + half + at * half) * (to - from));
  }
  return sum * (to - from).norm();
}

}  // namespace alignability::test
