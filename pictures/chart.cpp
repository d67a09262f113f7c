// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/chart.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/range.hpp"
#include "pictures/colour_map.hpp"
#include "pictures/text.hpp"

namespace alignability::detail {
namespace {

constexpr double kSpacingAlongX = 90.0;
constexpr double kSpacingAlongY = 70.0;
constexpr double kNoteGap = 10.0;
constexpr double kNotePitch = 17.0;
constexpr double kBetweenNotes = 12.0;
constexpr double kLargest = 1e300;  // on any axis, so that its ends are finite
constexpr double kSlack = 0.06;     // of a linear axis, beyond its values

void draw_dashed(const Context& context, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  set_colour(context, kFaintInk);
  context->set_line_width(1.0);
  context->set_dash(std::vector<double>{4.0, 4.0}, 0.0);
  context->move_to(from.x(), from.y());
  context->line_to(to.x(), to.y());
  context->stroke();
  context->unset_dash();
}

std::vector<Threshold> ascending(std::span<const Threshold> thresholds) {
  std::vector<Threshold> sorted;
  std::ranges::copy_if(thresholds, std::back_inserter(sorted), [](const Threshold& threshold) { return std::isfinite(threshold.value); });
  std::ranges::stable_sort(sorted, {}, &Threshold::value);
  return sorted;
}

std::string note_of(const Threshold& threshold) { return threshold.name + " " + to_text(threshold.value); }

}  // namespace

Eigen::Vector2d Chart::at(double along_x, double along_y) const {
  return {frame.left + x.share(along_x) * frame.width, frame.bottom() - y.share(along_y) * frame.height};
}

void draw_upper_chart(const Context& context, const Chart& chart, const std::string& y_name) {
  const Ticks along_y = ticks_within(chart.y, chart.frame.height, kSpacingAlongY);
  outline_rectangle(context, chart.frame, kInk);
  draw_y_ticks(context, along_y, chart.frame, chart.y);
  draw_y_name(context, y_name, chart.frame, along_y.widest_label());
}

void draw_chart(const Context& context, const Chart& chart, const AxisNames& names) {
  draw_upper_chart(context, chart, names.y);
  draw_x_ticks(context, ticks_within(chart.x, chart.frame.width, kSpacingAlongX), chart.frame, chart.x);
  draw_x_name(context, names.x, chart.frame);
}

void draw_thresholds_of_y(const Context& context, const Chart& chart, std::span<const Threshold> thresholds) {
  double free_from = chart.frame.bottom() + kNotePitch;
  for (const Threshold& threshold : ascending(thresholds)) {
    const double y = std::floor(chart.at(chart.x.from, threshold.value).y()) + 0.5;
    draw_dashed(context, {chart.frame.left, y}, {chart.frame.right(), y});
    free_from = std::min(y, free_from - kNotePitch);
    draw_note(context, note_of(threshold), {chart.frame.right() + kNoteGap, free_from}, {0.0, 0.5});
  }
}

void draw_thresholds_of_x(const Context& context, const Chart& chart, std::span<const Threshold> thresholds) {
  double free_from = chart.frame.left;
  for (const Threshold& threshold : ascending(thresholds)) {
    const double x = std::floor(chart.at(threshold.value, chart.y.from).x()) + 0.5;
    draw_dashed(context, {x, chart.frame.top}, {x, chart.frame.bottom()});
    const double width = text_width(note_of(threshold), kNoteSize, Weight::normal);
    const double left = std::max(x - 0.5 * width, free_from);
    draw_note(context, note_of(threshold), {left, chart.frame.top - kNoteGap}, {0.0, 1.0});
    free_from = left + width + kBetweenNotes;
  }
}

void stroke_curve(const Context& context, const Colour& colour, LineStyle style) {
  context->set_line_join(Cairo::Context::LineJoin::ROUND);
  set_colour(context, colour);
  context->set_line_width(2.5);
  if (style == LineStyle::dashed) context->set_dash(std::vector<double>{10.0, 5.0}, 0.0);
  context->stroke();
  context->unset_dash();
}

void draw_curve(const Context& context, const Chart& chart, std::span<const Eigen::Vector2d> points, const Colour& colour,
                LineStyle style) {
  context->begin_new_path();
  bool gap = true;
  for (const Eigen::Vector2d& point : points) {
    const Eigen::Vector2d at = chart.at(point.x(), point.y());
    const bool known = at.allFinite();
    if (known) gap ? context->move_to(at.x(), at.y()) : context->line_to(at.x(), at.y());
    gap = !known;
  }
  stroke_curve(context, colour, style);
}

Span span_from_zero(double largest) { return {0.0, largest > 0.0 ? 1.08 * largest : 1.0}; }

Span span_of(std::span<const double> values, const ChartAxis& axis) {
  const bool logarithmic = axis.scale == AxisScale::logarithmic;
  std::vector<double> shown;
  const auto add = [&](double value) {
    if (!std::isfinite(value) || (value <= 0.0 && logarithmic)) return;
    shown.push_back(std::clamp(value, logarithmic ? 1.0 / kLargest : -kLargest, kLargest));
  };
  std::ranges::for_each(values, add);
  for (const Threshold& threshold : axis.thresholds) add(threshold.value);
  if (!logarithmic) shown.push_back(0.0);
  if (shown.empty()) return {0.1, 1.0, axis.scale};

  const auto [least, largest] = std::ranges::minmax(shown);
  if (logarithmic) return round_span(least, largest);
  if (least == largest) return {};
  const double slack = kSlack * (largest - least);
  return {least < 0.0 ? least - slack : 0.0, largest > 0.0 ? largest + slack : 0.0, axis.scale};
}

}  // namespace alignability::detail
