// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/map_layout.hpp"

#include <cmath>

#include "pictures/axes.hpp"
#include "pictures/text.hpp"

namespace alignability::detail {
namespace {

constexpr double kTitleHeight = 42.0;
constexpr double kKeyLineHeight = 31.0;
constexpr double kKeyGap = 8.0;
constexpr double kLegendGap = 28.0;

double title_height(const std::string& title) { return title.empty() ? 0.0 : kTitleHeight; }

}  // namespace

MapLayout lay_out(View view, const std::string& title, std::size_t key_lines, double legend_width) {
  const double key_height = key_lines == 0 ? 0.0 : static_cast<double>(key_lines) * kKeyLineHeight + kKeyGap;
  view.frame.left = std::ceil(kMargin + left_of_frame(ticks_along_y(view)));
  view.frame.top = kMargin + title_height(title) + key_height;
  MapLayout layout;
  layout.view = view;
  layout.legend = {view.frame.right() + kLegendGap, view.frame.top, legend_width, view.frame.height};
  layout.width = layout.legend.right() + kMargin;
  layout.bottom = view.frame.bottom() + kBelowFrame;
  return layout;
}

void draw_title(const Context& context, const MapLayout& layout, const std::string& title) {
  const double left = layout.view.frame.left;
  draw_text(context, title, {left, kMargin},
            {.size = kTitleSize, .weight = Weight::bold, .anchor = {0.0, 0.0}, .widest = layout.width - kMargin - left});
}

Eigen::Vector2d key_line(const MapLayout& layout, const std::string& title, std::size_t line) {
  return {layout.view.frame.left, kMargin + title_height(title) + (static_cast<double>(line) + 0.5) * kKeyLineHeight};
}

}  // namespace alignability::detail
