// SPDX-License-Identifier: BSD-3-Clause
#include "costmap/scenario_map.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "costmap/heading_layers.hpp"

namespace alignability {
namespace {

// Cell by cell the value of that rank, from the least on; no value is less than any.
Grid<float> ranked(std::span<const Grid<float>* const> layers, std::ptrdiff_t rank) {
  const auto is_less = [](float a, float b) { return std::isnan(b) ? false : std::isnan(a) || a < b; };
  Grid<float> values(layers.front()->geometry(), 0.0f);
  std::vector<float> of_cell(layers.size());
  for (std::size_t cell = 0; cell < values.values().size(); ++cell) {
    std::ranges::transform(layers, of_cell.begin(), [&](const Grid<float>* layer) { return (*layer)[cell]; });
    std::ranges::nth_element(of_cell, of_cell.begin() + rank, is_less);
    values[cell] = of_cell[static_cast<std::size_t>(rank)];
  }
  return values;
}

}  // namespace

AlignabilityMap scenario_map(std::span<const AlignabilityMap> maps, double quantile) {
  if (maps.empty()) throw std::invalid_argument("there must be at least one alignability map");
  if (!(quantile >= 0.0 && quantile <= 1.0)) throw std::invalid_argument("a quantile must be in [0, 1]");
  const GridGeometry& geometry = maps.front().geometry;
  if (std::ranges::any_of(maps, [&](const AlignabilityMap& map) { return map.geometry != geometry; })) {
    throw std::invalid_argument("alignability maps of one site must have the same grid");
  }
  const std::size_t headings = heading_layers(maps.front()).size();
  if (std::ranges::any_of(maps, [&](const AlignabilityMap& map) { return heading_layers(map).size() != headings; })) {
    throw std::invalid_argument("alignability maps of one site must have the same headings");
  }
  const auto rank = static_cast<std::ptrdiff_t>(std::floor(quantile * static_cast<double>(maps.size() - 1)));
  const auto add = [&](AlignabilityMap& map, const std::string& name) {
    std::vector<const Grid<float>*> layers;
    for (const AlignabilityMap& scenario : maps) layers.push_back(scenario.find_layer(name));
    map.layers.push_back({name, ranked(layers, rank)});
  };
  AlignabilityMap map;
  map.geometry = geometry;
  add(map, "alpha");
  for (std::size_t heading = 0; heading < headings; ++heading) add(map, heading_layer_name(heading));
  return map;
}

}  // namespace alignability
