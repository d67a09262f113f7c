// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/legend.hpp"

#include <algorithm>
#include <cmath>

#include "core/range.hpp"
#include "pictures/axes.hpp"
#include "pictures/map_layers.hpp"
#include "pictures/text.hpp"

namespace alignability::detail {
namespace {

constexpr double kBarWidth = 24.0;
constexpr double kLongestBar = 560.0;
constexpr double kHeading = 34.0;
constexpr double kSwatchSide = 20.0;
constexpr double kSwatchPitch = 31.0;
constexpr double kBarGap = 28.0;  // to the swatches
constexpr double kTipHeight = 18.0;
constexpr double kTickSpacing = 60.0;
constexpr double kLeastPitch = 24.0;  // between labels

void draw_level(const Context& context, double y, double from, double to) {
  set_colour(context, kInk);
  context->set_line_width(1.0);
  context->move_to(from, y);
  context->line_to(to, y);
  context->stroke();
}

double level_of(const Rectangle& bar, double share) {
  return std::clamp(std::floor(bar.bottom() - share * bar.height), bar.top, bar.bottom() - 1.0) + 0.5;
}

void draw_scale_label(const Context& context, const Rectangle& bar, double share, const std::string& label) {
  draw_level(context, level_of(bar, share), bar.right(), bar.right() + 6.0);
  draw_text(context, label, {bar.right() + 11.0, bar.bottom() - share * bar.height}, {.size = kTickSize, .anchor = {0.0, 0.5}});
}

// Its line across the scale, and its note where the ticks' labels end.
void draw_threshold(const Context& context, const Rectangle& bar, double share, const Threshold& threshold) {
  draw_level(context, level_of(bar, share), bar.left, bar.right() + 6.0);
  draw_note(context, threshold.name + " " + to_text(threshold.value), {bar.right() + 46.0, bar.bottom() - share * bar.height}, {0.0, 0.5});
}

// What lies beyond the end has the last colour.
void draw_open_end(const Context& context, const Rectangle& bar, const Colour& last) {
  context->begin_new_path();
  context->move_to(bar.left + 0.5, bar.top + 0.5);
  context->line_to(bar.left + 0.5 * bar.width, bar.top - kTipHeight + 1.0);
  context->line_to(bar.right() - 0.5, bar.top + 0.5);
  set_colour(context, last);
  context->fill_preserve();
  set_colour(context, kInk);
  context->set_line_width(1.0);
  context->stroke();
}

// With an open end the last label is that of the end, and those too near to it give way.
void draw_scale_labels(const Context& context, const Rectangle& bar, const MapLegend& legend) {
  const Span span{legend.from, legend.limit};
  const Ticks ticks = ticks_within(span, bar.height, kTickSpacing);
  const bool open = legend.end == ScaleEnd::open;
  const double last = open ? 1.0 - kLeastPitch / bar.height : 1.0;
  for (const double value : ticks.values) {
    if (span.share(value) <= last + 1e-9) draw_scale_label(context, bar, span.share(value), ticks.label(value));
  }
  if (open) draw_scale_label(context, bar, 1.0, "≥ " + to_text(legend.limit));
}

void draw_scale(const Context& context, const Rectangle& bar, const MapLegend& legend) {
  for (double y = 0.0; y < bar.height; ++y) {
    const double value = std::lerp(legend.limit, legend.from, (y + 0.5) / bar.height);
    fill_rectangle(context, {bar.left, bar.top + y, bar.width, 1.0}, legend.colour_of(value));
  }
  if (legend.end == ScaleEnd::open) draw_open_end(context, bar, legend.colour_of(legend.limit));
  outline_rectangle(context, bar, kInk);
  draw_scale_labels(context, bar, legend);
  for (const Threshold& threshold : legend.thresholds) {
    draw_threshold(context, bar, Span{legend.from, legend.limit}.share(threshold.value), threshold);
  }
}

void draw_swatch(const Context& context, double left, double top, const Swatch& swatch) {
  const Rectangle patch{left, top, kBarWidth, kSwatchSide};
  swatch.draw(context, patch);
  draw_text(context, swatch.label, {patch.right() + 11.0, patch.top + 0.5 * patch.height}, {.size = kTickSize, .anchor = {0.0, 0.5}});
}

}  // namespace

std::vector<Swatch> map_swatches(const std::string& without_value, Tone tone) {
  const auto grey = [](const Context& context, const Rectangle& patch) {
    fill_rectangle(context, patch, kNotEvaluated);
    outline_rectangle(context, patch, kInk);
  };
  const auto unknown = [](const Context& context, const Rectangle& patch) {
    paint_hatch(context, patch);
    outline_rectangle(context, patch, kInk);
  };
  const auto wall = [tone](const Context& context, const Rectangle& patch) { fill_rectangle(context, patch, wall_colour(tone)); };
  return {{without_value, grey}, {"unknown", unknown}, {"occupied", wall}};
}

MapLegend alignability_legend(const RiskOptions& risk, Tone tone) {
  return {.name = "alignability α",
          .colour_of = alignability_scale(tone),
          .limit = 1.0,
          .end = ScaleEnd::closed,
          .thresholds = {{risk.alpha_critical, "critical"}, {risk.alpha_safe, "safe"}},
          .swatches = map_swatches("not evaluated", tone)};
}

void draw_map_legend(const Context& context, const Rectangle& area, const MapLegend& legend) {
  draw_text(context, legend.name, {area.left, area.top}, {.anchor = {0.0, 0.0}, .widest = area.width});
  const double top = area.top + kHeading + (legend.end == ScaleEnd::open ? kTipHeight : 0.0);
  const double swatches = kSwatchPitch * static_cast<double>(legend.swatches.size()) - (kSwatchPitch - kSwatchSide);
  const double room = area.bottom() - top - kBarGap - swatches;
  const Rectangle bar{area.left, top, kBarWidth, std::floor(std::min(room, kLongestBar))};
  draw_scale(context, bar, legend);
  double y = bar.bottom() + kBarGap;
  for (const Swatch& swatch : legend.swatches) {
    draw_swatch(context, bar.left, y, swatch);
    y += kSwatchPitch;
  }
}

}  // namespace alignability::detail
