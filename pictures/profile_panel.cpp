// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/profile_panel.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "pictures/blind_stretches.hpp"
#include "pictures/chart.hpp"
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

void draw_alpha(const Context& context, const Chart& chart, const DrawnPath& path) {
  std::vector<Eigen::Vector2d> points;
  for (const ProfilePoint& point : path.profile) points.emplace_back(point.s, point.alpha);
  draw_curve(context, chart, points, path.colour, path.style);
}

// Where the path is not blind, a thin line in its colour.
void draw_strip(const Context& context, const Chart& chart, double top, const DrawnPath& path, const RiskOptions& risk) {
  if (path.profile.empty()) return;
  const auto x_of = [&](double s) { return chart.at(s, 0.0).x(); };
  const double middle = std::round(top + 0.5 * kStripHeight);
  fill_rectangle(context, {chart.frame.left, middle - 1.5, x_of(path.profile.back().s) - chart.frame.left, 3.0}, path.colour);
  for (const Stretch& stretch : blind_stretches(path.profile, risk)) {
    const double left = x_of(stretch.from);
    fill_rectangle(context, {left, top, x_of(stretch.to) - left, kStripHeight}, kBlind);
    fill_rectangle(context, {left, middle - 1.5, x_of(stretch.to) - left, 3.0}, path.colour);
  }
}

}  // namespace

double profile_height(std::size_t paths) { return kCurvesHeight + 2.0 * kStripsPadding + kStripPitch * static_cast<double>(paths); }

double longest_profile(std::span<const DrawnPath> paths) {
  double longest = 0.0;
  for (const DrawnPath& path : paths) {
    if (!path.profile.empty()) longest = std::max(longest, path.profile.back().s);
  }
  return longest;
}

void draw_profiles(const Context& context, const Rectangle& area, std::span<const DrawnPath> paths, double longest,
                   const RiskOptions& risk) {
  const Chart chart{{area.left, area.top, area.width, kCurvesHeight}, {0.0, longest > 0.0 ? longest : 1.0}, {0.0, highest_of(paths, risk)}};
  const double critical = chart.at(0.0, risk.alpha_critical).y();
  fill_rectangle(context, {area.left, critical, area.width, chart.frame.bottom() - critical}, kBlindGround);
  draw_thresholds_of_y(context, chart, std::vector<Threshold>{{risk.alpha_critical, "critical"}, {risk.alpha_safe, "safe"}});
  for (const LineStyle style : {LineStyle::solid, LineStyle::dashed}) {
    for (const DrawnPath& path : paths) {
      if (path.style == style) draw_alpha(context, chart, path);
    }
  }

  const double first = chart.frame.bottom() + kStripsPadding + 0.5 * (kStripPitch - kStripHeight);
  for (std::size_t i = 0; i < paths.size(); ++i) {
    draw_strip(context, chart, std::round(first + kStripPitch * static_cast<double>(i)), paths[i], risk);
  }
  draw_note(context, "blind stretches", {area.right() + kNoteGap, 0.5 * (chart.frame.bottom() + area.bottom())}, {0.0, 0.5});

  outline_rectangle(context, area, kInk);
  outline_rectangle(context, chart.frame, kInk);
  const Ticks along_y = ticks_within(chart.y, chart.frame.height, 50.0);
  draw_x_ticks(context, ticks_within(chart.x, area.width, 110.0), area, chart.x);
  draw_y_ticks(context, along_y, chart.frame, chart.y);
  draw_x_name(context, "distance along the path [m]", area);
  draw_y_name(context, "alignability α", chart.frame, along_y.widest_label());
}

}  // namespace alignability::detail
