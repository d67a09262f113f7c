// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/scatter_picture.hpp"

#include <algorithm>
#include <numbers>

#include "pictures/chart.hpp"
#include "pictures/map_layout.hpp"
#include "pictures/text.hpp"

namespace alignability {
namespace {

using namespace detail;

constexpr double kPanelWidth = 560.0;
constexpr double kPanelHeight = 460.0;
constexpr double kLeft = 100.0;
constexpr double kBetween = 210.0;  // for the notes of a panel and the axis of the next
constexpr double kNotesWidth = 120.0;
constexpr double kTitleHeight = 70.0;
constexpr double kKeyPitch = 28.0;
constexpr double kNotesHeight = 34.0;
constexpr double kRadius = 3.2;
constexpr double kKeyRadius = 5.0;
constexpr double kOpacity = 0.45;

std::vector<double> values_along(const ScatterPanel& panel, Eigen::Index axis) {
  std::vector<double> values;
  for (const ScatterSeries& series : panel.series) {
    for (const Eigen::Vector2d& point : series.points) {
      if (point.allFinite()) values.push_back(point[axis]);
    }
  }
  return values;
}

void draw_dot(const Context& context, const Eigen::Vector2d& at, double radius, const Colour& colour, double opacity) {
  context->begin_new_path();
  context->arc(at.x(), at.y(), radius, 0.0, 2.0 * std::numbers::pi);
  set_colour(context, colour, opacity);
  context->fill();
}

void draw_points(const Context& context, const Chart& chart, const ScatterSeries& series) {
  for (const Eigen::Vector2d& point : series.points) {
    if (point.allFinite()) draw_dot(context, chart.at(point.x(), point.y()), kRadius, series.colour, kOpacity);
  }
}

std::size_t labels_of(const ScatterPanel& panel) {
  return static_cast<std::size_t>(std::ranges::count_if(panel.series, [](const ScatterSeries& series) { return !series.label.empty(); }));
}

void draw_key(const Context& context, const Chart& chart, const ScatterPanel& panel) {
  double y = chart.frame.top - kNotesHeight - kKeyPitch * (static_cast<double>(labels_of(panel)) - 0.5);
  for (const ScatterSeries& series : panel.series) {
    if (series.label.empty()) continue;
    draw_dot(context, {chart.frame.left + kKeyRadius, y}, kKeyRadius, series.colour, 1.0);
    const double left = chart.frame.left + 2.0 * kKeyRadius + 10.0;
    draw_text(context, series.label, {left, y}, {.anchor = {0.0, 0.5}, .widest = chart.frame.right() - left});
    y += kKeyPitch;
  }
}

void draw_panel(const Context& context, const Rectangle& frame, const ScatterPanel& panel) {
  const Chart chart{frame, span_of(values_along(panel, 0), panel.x), span_of(values_along(panel, 1), panel.y)};
  for (const ScatterSeries& series : panel.series) draw_points(context, chart, series);
  draw_thresholds_of_x(context, chart, panel.x.thresholds);
  draw_thresholds_of_y(context, chart, panel.y.thresholds);
  draw_chart(context, chart, {panel.x.name, panel.y.name});
  draw_key(context, chart, panel);
}

}  // namespace

void draw_scatter(std::span<const ScatterPanel> panels, const std::string& title, const std::filesystem::path& file) {
  std::size_t labels = 0;
  for (const ScatterPanel& panel : panels) labels = std::max(labels, labels_of(panel));
  const double top = kTitleHeight + kKeyPitch * static_cast<double>(labels) + kNotesHeight;
  const bool notes = !panels.empty() && !panels.back().y.thresholds.empty();
  const double count = std::max(1.0, static_cast<double>(panels.size()));
  const double width = kLeft + count * kPanelWidth + (count - 1.0) * kBetween + (notes ? kNotesWidth : 0.0) + kMargin;
  const Page page(width, top + kPanelHeight + kBelowFrame + kMargin);
  const Context& context = page.context();
  draw_text(context, title, {kLeft, kMargin},
            {.size = kTitleSize, .weight = Weight::bold, .anchor = {0.0, 0.0}, .widest = width - kMargin - kLeft});
  double left = kLeft;
  for (const ScatterPanel& panel : panels) {
    draw_panel(context, {left, top, kPanelWidth, kPanelHeight}, panel);
    left += kPanelWidth + kBetween;
  }
  page.save(file);
}

}  // namespace alignability
