// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/distribution_picture.hpp"

#include <algorithm>

#include "pictures/chart.hpp"
#include "pictures/map_layout.hpp"
#include "pictures/text.hpp"

namespace alignability {
namespace {

using namespace detail;

constexpr double kPanelWidth = 560.0;
constexpr double kPanelHeight = 420.0;
constexpr double kLeft = 100.0;
constexpr double kBetween = 120.0;
constexpr double kTop = 90.0;
constexpr double kKeyPitch = 28.0;
constexpr double kKeyLine = 44.0;

Span span_of(const DistributionPanel& panel) {
  double least = panel.from;
  double largest = panel.from;
  for (const DistributionCurve& curve : panel.curves) {
    for (const double value : curve.values) {
      least = std::min(least, value);
      largest = std::max(largest, value);
    }
  }
  const double extent = largest > least ? largest - least : 1.0;
  return {least, least + 1.05 * extent};
}

// A step up at each value.
void draw_curve(const Context& context, const Chart& chart, const DistributionCurve& curve) {
  std::vector<double> ascending = curve.values;
  std::ranges::sort(ascending);
  const auto line_to = [&](double value, double share) {
    const Eigen::Vector2d at = chart.at(value, share);
    context->line_to(at.x(), at.y());
  };
  context->begin_new_path();
  double share = 0.0;
  line_to(chart.x.from, share);
  for (std::size_t i = 0; i < ascending.size(); ++i) {
    line_to(ascending[i], share);
    share = static_cast<double>(i + 1) / static_cast<double>(ascending.size());
    line_to(ascending[i], share);
  }
  line_to(chart.x.to, share);
  stroke_curve(context, curve.colour, curve.style);
}

// In the lower right corner, where a cumulative curve never is for long.
void draw_key(const Context& context, const Chart& chart, const std::vector<DistributionCurve>& curves) {
  double y = chart.frame.bottom() - 24.0;
  for (const DistributionCurve& curve : curves) {
    if (curve.label.empty()) continue;
    const double right = chart.frame.right() - 20.0;
    context->begin_new_path();
    context->move_to(right - kKeyLine, y);
    context->line_to(right, y);
    stroke_curve(context, curve.colour, curve.style);
    draw_rimmed_text(context, curve.label, {right - kKeyLine - 12.0, y}, {.anchor = {1.0, 0.5}});
    y -= kKeyPitch;
  }
}

}  // namespace

void draw_distributions(std::span<const DistributionPanel> panels, const std::string& title, const std::filesystem::path& file) {
  const auto count = static_cast<double>(panels.size());
  const Page page(kLeft + count * kPanelWidth + std::max(0.0, count - 1.0) * kBetween + 40.0, kTop + kPanelHeight + kBelowFrame + kMargin);
  const Context& context = page.context();
  draw_text(context, title, {kLeft, 50.0}, {.size = kTitleSize, .weight = Weight::bold, .anchor = {0.0, 1.0}});
  double left = kLeft;
  for (const DistributionPanel& panel : panels) {
    const Chart chart{{left, kTop, kPanelWidth, kPanelHeight}, span_of(panel), {0.0, 1.0}};
    for (const DistributionCurve& curve : panel.curves) draw_curve(context, chart, curve);
    draw_chart(context, chart, {panel.name, "share of pairs with at most that"});
    draw_key(context, chart, panel.curves);
    left += kPanelWidth + kBetween;
  }
  page.save(file);
}

}  // namespace alignability
