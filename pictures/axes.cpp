// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/axes.hpp"

#include <algorithm>
#include <cmath>

#include "core/range.hpp"
#include "pictures/text.hpp"

namespace alignability::detail {
namespace {

constexpr double kTickLength = 6.0;
constexpr double kTickGap = 5.0;
constexpr double kNameGap = 14.0;
constexpr double kNameDrop = 40.0;  // from the frame to the top of the x axis' name
constexpr double kSpacingAlongX = 110.0;
constexpr double kSpacingAlongY = 80.0;
constexpr double kBarShare = 0.22;  // of the frame's width, at most
constexpr double kBarHeight = 7.0;

double on_pixel(double position) { return std::floor(position) + 0.5; }

}  // namespace

double Ticks::widest_label() const {
  double widest = 0.0;
  for (const double value : values) widest = std::max(widest, text_width(fixed_text(value, decimals), kTickSize, Weight::normal));
  return widest;
}

double round_step(double least) {
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    // A step that is there but for rounding is there.
    if (factor * power >= least * (1.0 - 1e-9)) return factor * power;
  }
  return 10.0 * power;
}

Ticks ticks_within(double lower, double upper, double pixels, double spacing) {
  const double step = round_step((upper - lower) * spacing / pixels);
  const double slack = 1e-6;
  Ticks ticks;
  ticks.decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + slack)));
  const double first = std::ceil(lower / step - slack);
  const double last = std::floor(upper / step + slack);
  for (double i = first; i <= last; ++i) ticks.values.push_back(i * step);
  return ticks;
}

Ticks ticks_along_x(const View& view) { return ticks_within(view.lower.x(), view.upper().x(), view.frame.width, kSpacingAlongX); }
Ticks ticks_along_y(const View& view) { return ticks_within(view.lower.y(), view.upper().y(), view.frame.height, kSpacingAlongY); }

double left_of_frame(const Ticks& ticks) {
  const double labels = std::max(ticks.widest_label(), text_width("0.0", kTickSize, Weight::normal));
  return kTickLength + kTickGap + labels + kNameGap + capital_height(kLabelSize);
}

void draw_x_ticks(const Context& context, const Ticks& ticks, const Rectangle& frame, double lower, double upper) {
  for (const double value : ticks.values) {
    const double x = frame.left + (value - lower) / (upper - lower) * frame.width;
    set_colour(context, kInk);
    context->set_line_width(1.0);
    context->move_to(on_pixel(x), frame.bottom());
    context->line_to(on_pixel(x), frame.bottom() + kTickLength);
    context->stroke();
    draw_text(context, fixed_text(value, ticks.decimals), {x, frame.bottom() + kTickLength + kTickGap},
              {.size = kTickSize, .anchor = {0.5, 0.0}});
  }
}

void draw_y_ticks(const Context& context, const Ticks& ticks, const Rectangle& frame, double lower, double upper) {
  for (const double value : ticks.values) {
    const double y = frame.bottom() - (value - lower) / (upper - lower) * frame.height;
    set_colour(context, kInk);
    context->set_line_width(1.0);
    context->move_to(frame.left - kTickLength, on_pixel(y));
    context->line_to(frame.left, on_pixel(y));
    context->stroke();
    draw_text(context, fixed_text(value, ticks.decimals), {frame.left - kTickLength - kTickGap, y},
              {.size = kTickSize, .anchor = {1.0, 0.5}});
  }
}

void draw_x_name(const Context& context, const std::string& name, const Rectangle& frame) {
  draw_text(context, name, {frame.left + 0.5 * frame.width, frame.bottom() + kNameDrop}, {.anchor = {0.5, 0.0}});
}

void draw_y_name(const Context& context, const std::string& name, const Rectangle& frame, double widest_label) {
  draw_upward_text(context, name, {frame.left - kTickLength - kTickGap - widest_label - kNameGap, frame.top + 0.5 * frame.height},
                   {.anchor = {0.5, 1.0}});
}

void draw_axes(const Context& context, const View& view, const AxisNames& names) {
  const Ticks along_x = ticks_along_x(view);
  const Ticks along_y = ticks_along_y(view);
  outline_rectangle(context, view.frame, kInk);
  draw_x_ticks(context, along_x, view.frame, view.lower.x(), view.upper().x());
  draw_y_ticks(context, along_y, view.frame, view.lower.y(), view.upper().y());
  draw_x_name(context, names.x, view.frame);
  draw_y_name(context, names.y, view.frame, along_y.widest_label());
}

void draw_scale_bar(const Context& context, const View& view) {
  // The round lengths are 2 to 2.5 apart, so the next one below is never shorter than two fifths.
  const double longest = kBarShare * view.frame.width / view.scale;
  const double step = round_step(longest);
  const double length = step <= longest * (1.0 + 1e-9) ? step : round_step(longest / 2.5);
  const double pixels = length * view.scale;
  const double top = std::round(view.frame.bottom() + kNameDrop + 0.5 * (capital_height(kLabelSize) - kBarHeight));
  const Rectangle bar{std::round(view.frame.right() - pixels), top, std::round(pixels), kBarHeight};
  fill_rectangle(context, {bar.left, bar.top, std::round(0.5 * bar.width), bar.height}, kInk);
  outline_rectangle(context, bar, kInk);
  const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(length) + 1e-6)));
  draw_text(context, fixed_text(length, decimals) + " m", {bar.left - 10.0, bar.top + 0.5 * bar.height},
            {.size = kTickSize, .anchor = {1.0, 0.5}});
}

}  // namespace alignability::detail
