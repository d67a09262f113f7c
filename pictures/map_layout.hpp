// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "pictures/view.hpp"

namespace alignability::detail {

inline constexpr double kMargin = 28.0;
inline constexpr double kMapLegendWidth = 158.0;

/// Where the parts of a page with a map go: the title, and lines of a key, above the frame; the legend to its right; more below.
struct MapLayout {
  View view;
  Rectangle legend;     ///< level with the frame
  double width = 0.0;   ///< of the page [px]
  double bottom = 0.0;  ///< of the frame's axis; a margin below, the page may end
};

/// Above the frame there is room for the title, unless it is empty, and for that many lines of a key.
MapLayout lay_out(View view, const std::string& title, std::size_t key_lines, double legend_width = kMapLegendWidth);
void draw_title(const Context& context, const MapLayout& layout, const std::string& title);
/// The middle of the left end of the key's line.
Eigen::Vector2d key_line(const MapLayout& layout, const std::string& title, std::size_t line);

}  // namespace alignability::detail
