// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "core/pose.hpp"
#include "costmap/heading_layers.hpp"

namespace alignability::test {

/// A map with layers by heading: `alpha(place, yaw)` at the centres of cells, the first layer the least over the headings.
inline AlignabilityMap heading_map(const GridGeometry& geometry, std::size_t headings,
                                   const std::function<float(const Eigen::Vector2d&, double)>& alpha) {
  AlignabilityMap map;
  map.geometry = geometry;
  map.layers.push_back({"alpha", Grid<float>(geometry, 1.0f)});
  for (std::size_t heading = 0; heading < headings; ++heading) {
    const double yaw = 2.0 * std::numbers::pi * static_cast<double>(heading) / static_cast<double>(headings);
    Grid<float> values(geometry, 0.0f);
    for (std::size_t cell = 0; cell < geometry.size(); ++cell) {
      values[cell] = alpha(geometry.center(geometry.cell_of(cell)), yaw);
      float& least = map.layers.front().values[cell];
      least = std::isnan(values[cell]) || values[cell] < least ? values[cell] : least;
    }
    map.layers.push_back({heading_layer_name(heading), std::move(values)});
  }
  return map;
}

}  // namespace alignability::test
