// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "pictures/chart_axis.hpp"
#include "pictures/path_picture.hpp"

namespace alignability {

/// Points of one kind.
struct ScatterSeries {
  std::string label;                    ///< above its panel; none when empty
  std::vector<Eigen::Vector2d> points;  ///< those that are not finite are passed over
  Colour colour = kRiskAwareColour;
};

struct ScatterPanel {
  ChartAxis x;
  ChartAxis y;
  std::vector<ScatterSeries> series;
};

/// Draws a small translucent dot a point, the first series lowest, a panel beside the other. On a logarithmic axis what is not above 0 lies
/// at its lower end. O(points). Throws InputError when the file is not named .png, .svg or .pdf, or cannot be written.
void draw_scatter(std::span<const ScatterPanel> panels, const std::string& title, const std::filesystem::path& file);

}  // namespace alignability
