// SPDX-License-Identifier: BSD-3-Clause
#include "costmap/map_table.hpp"

#include <algorithm>
#include <cmath>

#include "core/range.hpp"

namespace alignability {

// What is written of a float: its sixth digit behind the point is the last that α has.
constexpr double kPerUnit = 1e6;

std::string to_csv(const AlignabilityMap& map) {
  std::string text = "x,y";
  for (const AlignabilityMap::Layer& layer : map.layers) text.append(",").append(layer.name);
  text += '\n';
  for (std::size_t i = 0; i < map.geometry.size(); ++i) {
    if (std::ranges::all_of(map.layers, [i](const AlignabilityMap::Layer& layer) { return std::isnan(layer.values[i]); })) continue;
    const Eigen::Vector2d center = map.geometry.center(map.geometry.cell_of(i));
    text.append(to_text(center.x())).append(",").append(to_text(center.y()));
    for (const AlignabilityMap::Layer& layer : map.layers) {
      text += ',';
      if (!std::isnan(layer.values[i])) text += to_text(std::round(kPerUnit * layer.values[i]) / kPerUnit);
    }
    text += '\n';
  }
  return text;
}

std::string world_file(const GridGeometry& geometry) {
  const Eigen::Vector2d top_left = geometry.center({0, geometry.height - 1});
  const std::string side = to_text(geometry.resolution);
  return side + "\n0\n0\n-" + side + '\n' + to_text(top_left.x()) + '\n' + to_text(top_left.y()) + '\n';
}

}  // namespace alignability
