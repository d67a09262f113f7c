// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "pictures/axes.hpp"

namespace alignability::detail {

/// The values that an axis of a chart spans; from < to.
struct Span {
  double from = 0.0;
  double to = 1.0;
};

/// Numbers drawn against numbers, y upwards.
struct Chart {
  Rectangle frame;
  Span x;
  Span y;

  Eigen::Vector2d at(double along_x, double along_y) const;
};

/// The frame of a chart with ticks and the names of both axes, left of it and below.
void draw_chart(const Context& context, const Chart& chart, const AxisNames& names);

/// From zero to a little over `largest`.
Span span_from_zero(double largest);

}  // namespace alignability::detail
