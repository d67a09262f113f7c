// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "costmap/risk_field.hpp"
#include "pictures/chart_axis.hpp"
#include "pictures/colour_map.hpp"
#include "pictures/page.hpp"

namespace alignability::detail {

/// A patch and what it stands for.
struct Swatch {
  std::string label;
  std::function<void(const Context&, const Rectangle&)> draw;
};

enum class ScaleEnd {
  closed,
  open,  ///< values beyond have the last colour, which an arrowhead says
};

/// What the colours of a map mean: a scale, and below it what is drawn otherwise.
struct MapLegend {
  std::string name;  ///< above the scale
  ColourScale colour_of;
  double from = 0.0;   ///< the scale goes from here
  double limit = 1.0;  ///< to here
  ScaleEnd end = ScaleEnd::closed;
  std::vector<Threshold> thresholds;
  std::vector<Swatch> swatches;
};

/// The grey of cells without a value, the unknown and the walls.
std::vector<Swatch> map_swatches(const std::string& without_value, Tone tone);
/// The scale of α with both thresholds of risk.
MapLegend alignability_legend(const RiskOptions& risk, Tone tone);

void draw_map_legend(const Context& context, const Rectangle& area, const MapLegend& legend);

}  // namespace alignability::detail
