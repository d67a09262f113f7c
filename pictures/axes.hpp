// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pictures/chart_axis.hpp"
#include "pictures/page.hpp"
#include "pictures/view.hpp"

namespace alignability::detail {

/// The values that an axis spans; from < to, and both positive where the scale is logarithmic.
struct Span {
  double from = 0.0;
  double to = 1.0;
  AxisScale scale = AxisScale::linear;

  /// How far along the axis a value lies: 0 at `from`, 1 at `to`.
  double share(double value) const;
};

/// Round values to write along an axis.
struct Ticks {
  std::vector<double> values;
  std::optional<int> decimals = 0;  ///< without it each has as many as it needs

  std::string label(double value) const;
  double widest_label() const;  ///< [px]
};

/// The 1, 2 or 5 times a power of ten that is next at or above `least`, > 0.
double round_step(double least);

/// The logarithmic span from the 1, 2 or 5 times a power of ten at or below `least` to the next at or above `largest`, and one step at
/// least; 0 < least <= largest.
Span round_span(double least, double largest);

/// About one tick per `spacing` of the `pixels` that the axis is long. On a logarithmic axis ticks are 1, 2 and 5 times the powers of ten,
/// or those powers, or every so many of them, as many as leave room for half the spacing between them.
Ticks ticks_within(const Span& span, double pixels, double spacing);
Ticks ticks_along_x(const View& view);
Ticks ticks_along_y(const View& view);

struct AxisNames {
  std::string x;
  std::string y;
};
inline const AxisNames kMapAxes{"x in map [m]", "y in map [m]"};

/// The frame of a view with ticks in metres and the names of both axes, left of it and below.
void draw_axes(const Context& context, const View& view, const AxisNames& names);
/// A bar of a round length, in the line of the x axis' name and flush with the frame's right edge.
void draw_scale_bar(const Context& context, const View& view);

void draw_x_ticks(const Context& context, const Ticks& ticks, const Rectangle& frame, const Span& span);
void draw_y_ticks(const Context& context, const Ticks& ticks, const Rectangle& frame, const Span& span);
void draw_x_name(const Context& context, const std::string& name, const Rectangle& frame);
void draw_y_name(const Context& context, const std::string& name, const Rectangle& frame, double widest_label);

/// What the ticks and the name of an axis take up beside the frame, and those of an axis of α under it would [px].
double left_of_frame(const Ticks& ticks);
inline constexpr double kBelowFrame = 64.0;

}  // namespace alignability::detail
