// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/profile_panel.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/range.hpp"
#include "pictures/axes.hpp"
#include "pictures/blind_stretches.hpp"
#include "pictures/colour_map.hpp"
#include "pictures/text.hpp"

namespace alignability::detail {
namespace {

constexpr double kCurvesHeight = 230.0;
constexpr double kStripPitch = 22.0;
constexpr double kStripHeight = 12.0;
constexpr double kStripsPadding = 8.0;
constexpr double kNoteGap = 10.0;
const Colour kBlindGround = mixed(kWhite, kBlind, 0.14);

// Arc length to the right, α upwards.
struct Panel {
  Rectangle curves;
  double longest = 1.0;  // [m]
  double highest = 1.0;  // α at the top

  double x(double s) const { return curves.left + s / longest * curves.width; }
  double y(double alpha) const { return curves.bottom() - alpha / highest * curves.height; }
};

double longest_of(std::span<const DrawnPath> paths) {
  double longest = 0.0;
  for (const DrawnPath& path : paths) {
    if (!path.profile.empty()) longest = std::max(longest, path.profile.back().s);
  }
  return longest > 0.0 ? longest : 1.0;
}

// A little over the highest curve, and over the safe threshold.
double highest_of(std::span<const DrawnPath> paths, const RiskOptions& risk) {
  double highest = risk.alpha_safe;
  for (const DrawnPath& path : paths) {
    for (const ProfilePoint& point : path.profile) {
      if (point.alpha > highest) highest = point.alpha;
    }
  }
  return std::min(1.0, std::ceil(1.05 * highest * 10.0) / 10.0);
}

void draw_threshold(const Context& context, const Panel& panel, double alpha, const std::string& name) {
  const double y = std::floor(panel.y(alpha)) + 0.5;
  set_colour(context, kFaintInk);
  context->set_line_width(1.0);
  context->set_dash(std::vector<double>{4.0, 4.0}, 0.0);
  context->move_to(panel.curves.left, y);
  context->line_to(panel.curves.right(), y);
  context->stroke();
  context->unset_dash();
  draw_text(context, name + " " + to_text(alpha), {panel.curves.right() + kNoteGap, y},
            {.size = kNoteSize, .colour = kFaintInk, .anchor = {0.0, 0.5}});
}

void trace_curve(const Context& context, const Panel& panel, const DrawnPath& path) {
  context->begin_new_path();
  bool unknown = true;
  for (const ProfilePoint& point : path.profile) {
    if (!std::isnan(point.alpha)) {
      unknown ? context->move_to(panel.x(point.s), panel.y(point.alpha)) : context->line_to(panel.x(point.s), panel.y(point.alpha));
    }
    unknown = std::isnan(point.alpha);
  }
}

void draw_curve(const Context& context, const Panel& panel, const DrawnPath& path) {
  context->set_line_join(Cairo::Context::LineJoin::ROUND);
  trace_curve(context, panel, path);
  set_colour(context, path.colour);
  context->set_line_width(2.5);
  if (path.style == LineStyle::dashed) context->set_dash(std::vector<double>{10.0, 5.0}, 0.0);
  context->stroke();
  context->unset_dash();
}

// Where the path is not blind, a thin line in its colour.
void draw_strip(const Context& context, const Panel& panel, double top, const DrawnPath& path, const RiskOptions& risk) {
  if (path.profile.empty()) return;
  const double middle = std::round(top + 0.5 * kStripHeight);
  fill_rectangle(context, {panel.curves.left, middle - 1.5, panel.x(path.profile.back().s) - panel.curves.left, 3.0}, path.colour);
  for (const Stretch& stretch : blind_stretches(path.profile, risk)) {
    const double left = panel.x(stretch.from);
    fill_rectangle(context, {left, top, panel.x(stretch.to) - left, kStripHeight}, kBlind);
    fill_rectangle(context, {left, middle - 1.5, panel.x(stretch.to) - left, 3.0}, path.colour);
  }
}

}  // namespace

double profile_height(std::size_t paths) { return kCurvesHeight + 2.0 * kStripsPadding + kStripPitch * static_cast<double>(paths); }

void draw_profiles(const Context& context, const Rectangle& area, std::span<const DrawnPath> paths, const RiskOptions& risk) {
  const Panel panel{{area.left, area.top, area.width, kCurvesHeight}, longest_of(paths), highest_of(paths, risk)};
  const double critical = panel.y(risk.alpha_critical);
  fill_rectangle(context, {area.left, critical, area.width, panel.curves.bottom() - critical}, kBlindGround);
  draw_threshold(context, panel, risk.alpha_critical, "critical");
  draw_threshold(context, panel, risk.alpha_safe, "safe");
  for (const LineStyle style : {LineStyle::solid, LineStyle::dashed}) {
    for (const DrawnPath& path : paths) {
      if (path.style == style) draw_curve(context, panel, path);
    }
  }

  const double first = panel.curves.bottom() + kStripsPadding + 0.5 * (kStripPitch - kStripHeight);
  for (std::size_t i = 0; i < paths.size(); ++i) {
    draw_strip(context, panel, std::round(first + kStripPitch * static_cast<double>(i)), paths[i], risk);
  }
  draw_text(context, "blind stretches", {area.right() + kNoteGap, 0.5 * (panel.curves.bottom() + area.bottom())},
            {.size = kNoteSize, .colour = kFaintInk, .anchor = {0.0, 0.5}});

  outline_rectangle(context, area, kInk);
  outline_rectangle(context, panel.curves, kInk);
  const Ticks along_y = ticks_within(0.0, panel.highest, panel.curves.height, 50.0);
  draw_x_ticks(context, ticks_within(0.0, panel.longest, area.width, 110.0), area, 0.0, panel.longest);
  draw_y_ticks(context, along_y, panel.curves, 0.0, panel.highest);
  draw_x_name(context, "distance along the path [m]", area);
  draw_y_name(context, "alignability α", panel.curves, along_y.widest_label());
}

}  // namespace alignability::detail
