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

Span span_along_x(const View& view) { return {view.lower.x(), view.upper().x()}; }
Span span_along_y(const View& view) { return {view.lower.y(), view.upper().y()}; }

// The 1, 2 or 5 times a power of ten that is next at or below a number > 0.
double round_down(double largest) {
  const double power = std::pow(10.0, std::floor(std::log10(largest) + 1e-9));
  for (const double factor : {5.0, 2.0}) {
    if (factor * power <= largest * (1.0 + 1e-9)) return factor * power;
  }
  return power;
}

// A small whole number times a power of ten, the nearest double to it.
double times_power(double factor, int power) { return power < 0 ? factor / std::pow(10.0, -power) : factor * std::pow(10.0, power); }

Ticks logarithmic_ticks(const Span& span, double pixels, double least_gap) {
  const double decade = pixels / (std::log10(span.to) - std::log10(span.from));
  const bool fine = decade * std::log10(2.0) >= least_gap;
  const int stride = fine ? 1 : std::max(1, static_cast<int>(std::ceil(least_gap / decade)));
  Ticks ticks{.values = {}, .decimals = std::nullopt};
  const auto first = static_cast<int>(std::floor(std::log10(span.from)));
  for (int power = first; power <= std::log10(span.to) + 1e-9; ++power) {
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double value = times_power(factor, power);
      const bool within = value >= span.from * (1.0 - 1e-9) && value <= span.to * (1.0 + 1e-9);
      const bool wanted = fine || (factor == 1.0 && power % stride == 0);
      if (within && wanted) ticks.values.push_back(value);
    }
  }
  return ticks;
}

}  // namespace

double Span::share(double value) const {
  if (scale == AxisScale::linear) return (value - from) / (to - from);
  return value <= 0.0 ? 0.0 : (std::log(value) - std::log(from)) / (std::log(to) - std::log(from));
}

std::string Ticks::label(double value) const { return decimals ? fixed_text(value, *decimals) : to_text(value); }

double Ticks::widest_label() const {
  double widest = 0.0;
  for (const double value : values) widest = std::max(widest, text_width(label(value), kTickSize, Weight::normal));
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

Span round_span(double least, double largest) {
  const double from = round_down(least);
  const double to = round_step(largest);
  return {from, to > from ? to : round_step(1.5 * from), AxisScale::logarithmic};
}

Ticks ticks_within(const Span& span, double pixels, double spacing) {
  if (span.scale == AxisScale::logarithmic) return logarithmic_ticks(span, pixels, 0.5 * spacing);
  const auto& [lower, upper, scale] = span;
  const double step = round_step((upper - lower) * spacing / pixels);
  const double slack = 1e-6;
  Ticks ticks;
  ticks.decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + slack)));
  const double first = std::ceil(lower / step - slack);
  const double last = std::floor(upper / step + slack);
  for (double i = first; i <= last; ++i) ticks.values.push_back(i * step);
  return ticks;
}

Ticks ticks_along_x(const View& view) { return ticks_within(span_along_x(view), view.frame.width, kSpacingAlongX); }
Ticks ticks_along_y(const View& view) { return ticks_within(span_along_y(view), view.frame.height, kSpacingAlongY); }

double left_of_frame(const Ticks& ticks) {
  const double labels = std::max(ticks.widest_label(), text_width("0.0", kTickSize, Weight::normal));
  return kTickLength + kTickGap + labels + kNameGap + capital_height(kLabelSize);
}

void draw_x_ticks(const Context& context, const Ticks& ticks, const Rectangle& frame, const Span& span) {
  for (const double value : ticks.values) {
    const double x = frame.left + span.share(value) * frame.width;
    set_colour(context, kInk);
    context->set_line_width(1.0);
    context->move_to(on_pixel(x), frame.bottom());
    context->line_to(on_pixel(x), frame.bottom() + kTickLength);
    context->stroke();
    draw_text(context, ticks.label(value), {x, frame.bottom() + kTickLength + kTickGap}, {.size = kTickSize, .anchor = {0.5, 0.0}});
  }
}

void draw_y_ticks(const Context& context, const Ticks& ticks, const Rectangle& frame, const Span& span) {
  for (const double value : ticks.values) {
    const double y = frame.bottom() - span.share(value) * frame.height;
    set_colour(context, kInk);
    context->set_line_width(1.0);
    context->move_to(frame.left - kTickLength, on_pixel(y));
    context->line_to(frame.left, on_pixel(y));
    context->stroke();
    draw_text(context, ticks.label(value), {frame.left - kTickLength - kTickGap, y}, {.size = kTickSize, .anchor = {1.0, 0.5}});
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
  draw_x_ticks(context, along_x, view.frame, span_along_x(view));
  draw_y_ticks(context, along_y, view.frame, span_along_y(view));
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
