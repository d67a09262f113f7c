// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/legend.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/range.hpp"
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

double height_of(const Rectangle& bar, double alpha) { return bar.bottom() - alpha * bar.height; }

void draw_level(const Context& context, const Rectangle& bar, double alpha, double from, double to) {
  const double y = std::clamp(std::floor(height_of(bar, alpha)), bar.top, bar.bottom() - 1.0) + 0.5;
  set_colour(context, kInk);
  context->set_line_width(1.0);
  context->move_to(from, y);
  context->line_to(to, y);
  context->stroke();
}

// The line across the scale, and its name where the ticks' labels end.
void draw_threshold(const Context& context, const Rectangle& bar, double alpha, const std::string& name) {
  draw_level(context, bar, alpha, bar.left, bar.right() + 6.0);
  draw_text(context, name + " " + to_text(alpha), {bar.right() + 46.0, height_of(bar, alpha)},
            {.size = kNoteSize, .colour = kFaintInk, .anchor = {0.0, 0.5}});
}

void draw_scale(const Context& context, const Rectangle& bar, const RiskOptions& risk, Tone tone) {
  for (double y = 0.0; y < bar.height; ++y) {
    fill_rectangle(context, {bar.left, bar.top + y, bar.width, 1.0}, alignability_colour(1.0 - (y + 0.5) / bar.height, tone));
  }
  outline_rectangle(context, bar, kInk);
  for (int tick = 0; tick <= 5; ++tick) {
    const double alpha = 0.2 * tick;
    draw_level(context, bar, alpha, bar.right(), bar.right() + 6.0);
    draw_text(context, fixed_text(alpha, 1), {bar.right() + 11.0, height_of(bar, alpha)}, {.size = kTickSize, .anchor = {0.0, 0.5}});
  }
  draw_threshold(context, bar, risk.alpha_critical, "critical");
  draw_threshold(context, bar, risk.alpha_safe, "safe");
}

Rectangle draw_swatch(const Context& context, double left, double top, const std::string& label) {
  const Rectangle swatch{left, top, kBarWidth, kSwatchSide};
  draw_text(context, label, {swatch.right() + 11.0, swatch.top + 0.5 * swatch.height}, {.size = kTickSize, .anchor = {0.0, 0.5}});
  return swatch;
}

void draw_swatches(const Context& context, double left, double top, Tone tone) {
  const Rectangle grey = draw_swatch(context, left, top, "not evaluated");
  fill_rectangle(context, grey, kNotEvaluated);
  outline_rectangle(context, grey, kInk);
  const Rectangle unknown = draw_swatch(context, left, top + kSwatchPitch, "unknown");
  paint_hatch(context, unknown);
  outline_rectangle(context, unknown, kInk);
  fill_rectangle(context, draw_swatch(context, left, top + 2.0 * kSwatchPitch, "occupied"), wall_colour(tone));
}

}  // namespace

void draw_map_legend(const Context& context, const Rectangle& area, const RiskOptions& risk, Tone tone) {
  draw_text(context, "alignability α", {area.left, area.top}, {.anchor = {0.0, 0.0}});
  const double swatches = 2.0 * kSwatchPitch + kSwatchSide;
  const double room = area.height - kHeading - kBarGap - swatches;
  const Rectangle bar{area.left, area.top + kHeading, kBarWidth, std::floor(std::min(room, kLongestBar))};
  draw_scale(context, bar, risk, tone);
  draw_swatches(context, bar.left, bar.bottom() + kBarGap, tone);
}

}  // namespace alignability::detail
