// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "costmap/occupancy_map.hpp"

namespace alignability::test {

/// From a point to a closed square given by its corners [m].
inline double distance_to_square(const Eigen::Vector2d& point, const Eigen::Vector2d& low, const Eigen::Vector2d& high) {
  const double dx = std::max({low.x() - point.x(), 0.0, point.x() - high.x()});
  const double dy = std::max({low.y() - point.y(), 0.0, point.y() - high.y()});
  return std::hypot(dx, dy);
}

/// The distance along a segment to a square is convex: its minimum by ternary search, to about 1e-12 of the length.
inline double distance_to_square(const Eigen::Vector2d& from, const Eigen::Vector2d& to, const Eigen::Vector2d& low,
                                 const Eigen::Vector2d& high) {
  const auto at = [&](double t) { return distance_to_square(Eigen::Vector2d(from + t * (to - from)), low, high); };
  double a = 0.0;
  double b = 1.0;
  for (int i = 0; i < 80; ++i) {
    const double third = (b - a) / 3.0;
    (at(a + third) <= at(b - third) ? b : a) = at(a + third) <= at(b - third) ? b - third : a + third;
  }
  return std::min({at(0.0), at(0.5 * (a + b)), at(1.0)});
}

/// From a point to the nearest point that is not free, every cell looked at; outside of the map nothing is free.
inline double brute_force_distance(const OccupancyMap& map, const Eigen::Vector2d& point) {
  const GridGeometry& geometry = map.geometry();
  const Eigen::Vector2d inside = (point - geometry.origin).cwiseMin(geometry.upper_corner() - point);
  double least = std::max(0.0, inside.minCoeff());
  for (std::size_t i = 0; i < geometry.size(); ++i) {
    if (map.is_free(i)) continue;
    const Cell cell = geometry.cell_of(i);
    least = std::min(least, distance_to_square(point, geometry.corner(cell), geometry.corner({cell.x + 1, cell.y + 1})));
  }
  return least;
}

/// The least of brute_force_distance along a segment; a border of the map is nearest at one of the ends.
inline double brute_force_distance(const OccupancyMap& map, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  const GridGeometry& geometry = map.geometry();
  double least = std::min(brute_force_distance(map, from), brute_force_distance(map, to));
  for (std::size_t i = 0; i < geometry.size(); ++i) {
    if (map.is_free(i)) continue;
    const Cell cell = geometry.cell_of(i);
    least = std::min(least, distance_to_square(from, to, geometry.corner(cell), geometry.corner({cell.x + 1, cell.y + 1})));
  }
  return least;
}

}  // namespace alignability::test
