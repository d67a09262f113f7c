// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/chart.hpp"

#include "pictures/colour_map.hpp"

namespace alignability::detail {

Eigen::Vector2d Chart::at(double along_x, double along_y) const {
  return {frame.left + (along_x - x.from) / (x.to - x.from) * frame.width,
          frame.bottom() - (along_y - y.from) / (y.to - y.from) * frame.height};
}

void draw_chart(const Context& context, const Chart& chart, const AxisNames& names) {
  const Ticks along_y = ticks_within(chart.y.from, chart.y.to, chart.frame.height, 70.0);
  outline_rectangle(context, chart.frame, kInk);
  draw_x_ticks(context, ticks_within(chart.x.from, chart.x.to, chart.frame.width, 90.0), chart.frame, chart.x.from, chart.x.to);
  draw_y_ticks(context, along_y, chart.frame, chart.y.from, chart.y.to);
  draw_x_name(context, names.x, chart.frame);
  draw_y_name(context, names.y, chart.frame, along_y.widest_label());
}

Span span_from_zero(double largest) { return {0.0, largest > 0.0 ? 1.08 * largest : 1.0}; }

}  // namespace alignability::detail
