// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <vector>

#include "costmap/alignability_map.hpp"
#include "tests/costmap/ascii_map.hpp"

namespace alignability::test {

inline AlignabilityMap alpha_map(const GridGeometry& geometry, std::vector<float> values) {
  AlignabilityMap map;
  map.geometry = geometry;
  map.layers.push_back({"alpha", Grid<float>(geometry, std::move(values))});
  return map;
}

inline AlignabilityMap uniform_alpha_map(const GridGeometry& geometry, float alpha) {
  return alpha_map(geometry, std::vector<float>(geometry.size(), alpha));
}

/// Two by two α-cells of 2 m, poor at the lower left, rich at the lower right, middling at the upper right, none at the upper left;
/// occupancy cells of 1 m with a wall in the upper left corner and the unknown at the upper right.
struct SmallSite {
  AlignabilityMap map = alpha_map({.resolution = 2.0, .origin = {-1.0, -3.0}, .width = 2, .height = 2},
                                  {0.02f, 0.95f, std::numeric_limits<float>::quiet_NaN(), 0.5f});
  OccupancyMap occupancy = ascii_map(1.0, {"#..?", "....", "....", "...."}, {-1.0, -3.0});

  Eigen::Vector2d poor{0.3, -2.0};
  Eigen::Vector2d rich{2.0, -2.0};
  Eigen::Vector2d middling{1.5, 0.5};
  Eigen::Vector2d none{0.5, -0.5};
  Eigen::Vector2d wall{-0.5, 0.5};
};

}  // namespace alignability::test
