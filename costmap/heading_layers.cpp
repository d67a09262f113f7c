// SPDX-License-Identifier: BSD-3-Clause
#include "costmap/heading_layers.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "core/pose.hpp"

namespace alignability {
namespace {

constexpr const char* kPrefix = "alpha_heading_";

std::size_t count_of_headings(std::span<const std::string> names) {
  return static_cast<std::size_t>(std::ranges::count_if(names, [](const std::string& name) { return name.starts_with(kPrefix); }));
}

}  // namespace

std::string heading_layer_name(std::size_t heading) { return kPrefix + std::to_string(heading); }

std::optional<std::string> fault_of_heading_layers(std::span<const std::string> names) {
  const std::size_t count = count_of_headings(names);
  if (count == 1) return "one heading alone says nothing of the others";
  for (std::size_t heading = 0; heading < count; ++heading) {
    std::string name = heading_layer_name(heading);
    if (std::ranges::find(names, name) != names.end()) continue;
    std::string fault = "of ";
    return fault.append(std::to_string(count)).append(" headings the layer '").append(name).append("' is missing");
  }
  return std::nullopt;
}

std::size_t nearest_heading(double yaw, std::size_t headings) {
  const double share = normalized_angle(yaw) / (2.0 * std::numbers::pi);
  return static_cast<std::size_t>(std::lround((share + 1.0) * static_cast<double>(headings))) % headings;
}

std::vector<const Grid<float>*> heading_layers(const AlignabilityMap& map) {
  std::vector<std::string> names;
  for (const AlignabilityMap::Layer& layer : map.layers) names.push_back(layer.name);
  if (const auto fault = fault_of_heading_layers(names)) throw std::invalid_argument(*fault);
  std::vector<const Grid<float>*> layers;
  for (std::size_t heading = 0; heading < count_of_headings(names); ++heading) {
    layers.push_back(map.find_layer(heading_layer_name(heading)));
    if (layers.back()->geometry() != map.geometry) throw std::invalid_argument(heading_layer_name(heading) + " has another grid");
  }
  return layers;
}

Grid<float> best_over_headings(const AlignabilityMap& map) {
  const std::vector<const Grid<float>*> layers = heading_layers(map);
  if (layers.empty()) return map.alpha();
  Grid<float> best = *layers.front();
  for (const Grid<float>* layer : layers) {
    for (std::size_t cell = 0; cell < map.geometry.size(); ++cell) {
      // What is no number is not less, and stays.
      if (!((*layer)[cell] <= best[cell])) best[cell] = std::isnan(best[cell]) ? best[cell] : (*layer)[cell];
    }
  }
  return best;
}

}  // namespace alignability
