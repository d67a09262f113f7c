// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "pictures/page.hpp"
#include "pictures/view.hpp"

namespace alignability::detail {

/// Round values within [lower, upper] to write along an axis.
struct Ticks {
  std::vector<double> values;
  int decimals = 0;

  double widest_label() const;  ///< [px]
};

/// The 1, 2 or 5 times a power of ten that is next at or above `least`, > 0.
double round_step(double least);

/// About one tick per `spacing` of the `pixels` that the axis is long.
Ticks ticks_within(double lower, double upper, double pixels, double spacing);
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

void draw_x_ticks(const Context& context, const Ticks& ticks, const Rectangle& frame, double lower, double upper);
void draw_y_ticks(const Context& context, const Ticks& ticks, const Rectangle& frame, double lower, double upper);
void draw_x_name(const Context& context, const std::string& name, const Rectangle& frame);
void draw_y_name(const Context& context, const std::string& name, const Rectangle& frame, double widest_label);

/// What the ticks and the name of an axis take up beside the frame, and those of an axis of α under it would [px].
double left_of_frame(const Ticks& ticks);
inline constexpr double kBelowFrame = 64.0;

}  // namespace alignability::detail
