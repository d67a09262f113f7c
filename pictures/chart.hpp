// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>
#include <vector>

#include "pictures/axes.hpp"
#include "pictures/chart_axis.hpp"
#include "pictures/path_picture.hpp"

namespace alignability::detail {

/// Numbers drawn against numbers, y upwards.
struct Chart {
  Rectangle frame;
  Span x;
  Span y;

  Eigen::Vector2d at(double along_x, double along_y) const;
};

/// The frame of a chart with ticks and the names of both axes, left of it and below.
void draw_chart(const Context& context, const Chart& chart, const AxisNames& names);
/// The same without the ticks and the name of the x axis, for a chart that stands on another.
void draw_upper_chart(const Context& context, const Chart& chart, const std::string& y_name);

/// Dashed lines across the frame, those at a y with their notes to its right, those at an x with theirs above it. Notes do not overlap.
void draw_thresholds_of_y(const Context& context, const Chart& chart, std::span<const Threshold> thresholds);
void draw_thresholds_of_x(const Context& context, const Chart& chart, std::span<const Threshold> thresholds);

/// Draws the path that the context holds as a curve of a chart.
void stroke_curve(const Context& context, const Colour& colour, LineStyle style);
/// Straight from point to point; one that is NaN leaves a gap.
void draw_curve(const Context& context, const Chart& chart, std::span<const Eigen::Vector2d> points, const Colour& colour, LineStyle style);

/// From zero to a little over `largest`.
Span span_from_zero(double largest);
/// The span of an axis that shows the values; those that are not finite, and on a logarithmic axis not positive, do not count.
Span span_of(std::span<const double> values, const ChartAxis& axis);

}  // namespace alignability::detail
