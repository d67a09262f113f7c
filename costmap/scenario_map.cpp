// SPDX-License-Identifier: BSD-3-Clause
#include "costmap/scenario_map.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace alignability {

AlignabilityMap scenario_map(std::span<const AlignabilityMap> maps, double quantile) {
  if (maps.empty()) throw std::invalid_argument("there must be at least one alignability map");
  if (!(quantile >= 0.0 && quantile <= 1.0)) throw std::invalid_argument("a quantile must be in [0, 1]");
  const GridGeometry& geometry = maps.front().geometry;
  if (std::ranges::any_of(maps, [&](const AlignabilityMap& map) { return map.geometry != geometry; })) {
    throw std::invalid_argument("alignability maps of one site must have the same grid");
  }
  const auto rank = static_cast<std::ptrdiff_t>(std::floor(quantile * static_cast<double>(maps.size() - 1)));
  const auto is_less = [](float a, float b) { return std::isnan(b) ? false : std::isnan(a) || a < b; };
  Grid<float> alpha(geometry, 0.0f);
  std::vector<float> of_cell(maps.size());
  for (std::size_t cell = 0; cell < geometry.size(); ++cell) {
    std::ranges::transform(maps, of_cell.begin(), [&](const AlignabilityMap& map) { return map.alpha()[cell]; });
    std::ranges::nth_element(of_cell, of_cell.begin() + rank, is_less);
    alpha[cell] = of_cell[static_cast<std::size_t>(rank)];
  }
  AlignabilityMap map;
  map.geometry = geometry;
  map.layers = {{"alpha", std::move(alpha)}};
  return map;
}

}  // namespace alignability
