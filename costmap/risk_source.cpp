// SPDX-License-Identifier: BSD-3-Clause
#include "costmap/risk_source.hpp"

#include <algorithm>
#include <cmath>

#include "core/range.hpp"
#include "costmap/clearance_map.hpp"

namespace alignability {
namespace {

std::string extent_text(const GridGeometry& grid) {
  const auto side = [&](int axis) {
    std::string text = to_text(grid.origin[axis]);
    return text.append(" to ").append(to_text(grid.upper_corner()[axis]));
  };
  std::string text = "x ";
  return text.append(side(0)).append(" and y ").append(side(1));
}

}  // namespace

Grid<float> clearance_values(const OccupancyMap& occupancy) {
  const ClearanceMap clearance(occupancy);
  GridGeometry corners = occupancy.geometry();
  corners.origin.array() -= 0.5 * corners.resolution;
  ++corners.width;
  ++corners.height;
  Grid<float> values(corners, 0.0f);
  for (std::size_t i = 0; i < values.values().size(); ++i) {
    values[i] = static_cast<float>(clearance.distance(occupancy.geometry().corner(corners.cell_of(i))));
  }
  return values;
}

bool covers(const GridGeometry& grid, const GridGeometry& other) {
  const double hair = 1e-6 * std::min(grid.resolution, other.resolution);
  return (other.origin - grid.origin).minCoeff() >= -hair && (grid.upper_corner() - other.upper_corner()).minCoeff() >= -hair;
}

bool is_source_name(const std::string& name) {
  constexpr const char* kLetters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
  return !name.empty() && name.find_first_not_of(kLetters) == std::string::npos;
}

std::optional<std::string> fault_of_source(const RiskSource& source, const GridGeometry& map) {
  if (!is_source_name(source.name)) return "the name of a risk's source must be made of letters, digits, '_' and '-'";
  if (source.name == kAlignability) return "alignability is a risk's source of its own";
  if (!kCostWeights.contains(source.weight)) return "a source's weight must be " + kCostWeights.description();
  if (!kFinite.contains(source.risky) || !kFinite.contains(source.safe)) return "'risky' and 'safe' must be finite";
  if (source.risky == source.safe) return "'risky' and 'safe' must differ";
  if (source.unknown == UnknownPolicy::blocked) return "only where alignability is unknown may it be blocked";
  if (!source.values) return "a risk's source needs values";
  if (!covers(source.values->geometry(), map)) {
    std::string fault = "the raster, ";
    return fault.append(extent_text(source.values->geometry())).append(", does not cover the map, ").append(extent_text(map));
  }
  if (std::ranges::any_of(source.values->values(), [](float value) { return std::isinf(value); })) return "the raster has infinite values";
  return std::nullopt;
}

const char* to_string(UnknownPolicy policy) {
  return policy == UnknownPolicy::risky ? "risky" : policy == UnknownPolicy::neutral ? "neutral" : "blocked";
}

double risk_of(double value, double risky, double safe, UnknownPolicy unknown) {
  if (std::isnan(value)) return unknown == UnknownPolicy::neutral ? 0.0 : 1.0;
  return std::clamp((safe - value) / (safe - risky), 0.0, 1.0);
}

}  // namespace alignability
