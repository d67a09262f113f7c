// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/merged_map.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "costmap/cell_offset.hpp"
#include "costmap/logged_map.hpp"

namespace alignability {
namespace {

constexpr const char* kLogged = "logged";

// Of a cell that has a value.
float logged_in(const AlignabilityMap& map, Cell cell) {
  const Grid<float>* layer = map.find_layer(kLogged);
  return layer != nullptr ? (*layer)[cell] : (is_logged(map) ? 1.0f : 0.0f);
}

void refuse_other_layers(const AlignabilityMap& a, const AlignabilityMap& b) {
  for (const AlignabilityMap::Layer& layer : a.layers) {
    if (layer.name != kLogged && b.find_layer(layer.name) == nullptr) {
      throw std::invalid_argument("have other layers: one has '" + layer.name + "', the other has not");
    }
  }
}

MergedMap merged_onto(const AlignabilityMap& base, const AlignabilityMap& winner) {
  refuse_other_layers(base, winner);
  refuse_other_layers(winner, base);
  const auto offset = offset_of(winner.geometry, base.geometry);
  if (!offset) throw std::invalid_argument("do not have the same cells: their corners or sizes differ");
  MergedMap result{.map = base};
  result.map.error_model.reset();
  std::erase_if(result.map.layers, [](const AlignabilityMap::Layer& layer) { return layer.name == kLogged; });
  Grid<float> logged(base.geometry, std::numeric_limits<float>::quiet_NaN());
  for (std::size_t i = 0; i < base.geometry.size(); ++i) {
    if (!std::isnan(base.alpha()[i])) logged[i] = logged_in(base, base.geometry.cell_of(i));
  }
  for (std::size_t i = 0; i < winner.geometry.size(); ++i) {
    if (std::isnan(winner.alpha()[i])) continue;
    const Cell cell = winner.geometry.cell_of(i);
    const Cell in_base{cell.x + offset->x, cell.y + offset->y};
    if (!base.geometry.contains(in_base)) {
      ++result.lost;
      continue;
    }
    ++result.taken;
    for (AlignabilityMap::Layer& layer : result.map.layers) layer.values[in_base] = (*winner.find_layer(layer.name))[i];
    logged[in_base] = logged_in(winner, cell);
  }
  result.map.layers.push_back({kLogged, std::move(logged)});
  return result;
}

}  // namespace

MergedMap merged(const AlignabilityMap& first, const AlignabilityMap& second) {
  return is_logged(second) && !is_logged(first) ? merged_onto(first, second) : merged_onto(second, first);
}

}  // namespace alignability
