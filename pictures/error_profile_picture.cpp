// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/error_profile_picture.hpp"

#include <algorithm>
#include <cmath>

#include "pictures/chart.hpp"
#include "pictures/map_layout.hpp"
#include "pictures/profile_panel.hpp"
#include "pictures/text.hpp"

namespace alignability {
namespace {

using namespace detail;

constexpr double kFrameWidth = 1000.0;
constexpr double kFrameHeight = 380.0;
constexpr double kLeft = 100.0;
constexpr double kTitleHeight = 42.0;
constexpr double kKeyPitch = 30.0;
constexpr double kKeyGap = 12.0;
constexpr double kSampleLength = 62.0;
constexpr double kSampleBand = 9.0;  // above the line
constexpr double kPanelGap = 30.0;
constexpr double kBandOpacity = 0.22;
constexpr double kRimWidth = 1.0;

// As the panel of α takes them.
std::vector<DrawnPath> paths_with_alpha(std::span<const ErrorProfile> profiles) {
  std::vector<DrawnPath> paths;
  for (const ErrorProfile& profile : profiles) {
    if (profile.alpha.empty()) continue;
    paths.push_back({.label = profile.label, .poses = {}, .profile = profile.alpha, .colour = profile.colour, .style = profile.style});
  }
  return paths;
}

double longest_of(std::span<const ErrorProfile> profiles, std::span<const DrawnPath> paths) {
  double longest = longest_profile(paths);
  for (const ErrorProfile& profile : profiles) {
    if (!profile.errors.empty()) longest = std::max(longest, profile.errors.back().s);
  }
  return longest > 0.0 ? longest : 1.0;
}

std::vector<double> errors_of(std::span<const ErrorProfile> profiles) {
  std::vector<double> errors;
  for (const ErrorProfile& profile : profiles) {
    for (const ErrorPoint& point : profile.errors) {
      errors.push_back(point.mean);
      errors.push_back(point.p95);
    }
  }
  return errors;
}

bool has_band(const ErrorPoint& point) { return std::isfinite(point.mean) && std::isfinite(point.p95); }

void fill_band(const Context& context, const Chart& chart, std::span<const ErrorPoint> run, const Colour& colour) {
  context->begin_new_path();
  const auto line_to = [&](double s, double error) {
    const Eigen::Vector2d at = chart.at(s, error);
    context->line_to(at.x(), at.y());
  };
  for (const ErrorPoint& point : run) line_to(point.s, point.mean);
  for (std::size_t i = run.size(); i > 0; --i) line_to(run[i - 1].s, run[i - 1].p95);
  context->close_path();
  set_colour(context, colour, kBandOpacity);
  context->fill();
}

// Its rim as a hairline, which tells one band from another where they overlap.
void draw_band(const Context& context, const Chart& chart, const ErrorProfile& profile) {
  for (auto begin = std::ranges::find_if(profile.errors, has_band); begin != profile.errors.end();) {
    const auto end = std::find_if_not(begin, profile.errors.end(), has_band);
    fill_band(context, chart, {begin, end}, profile.colour);
    context->begin_new_path();
    for (auto point = begin; point != end; ++point) {
      const Eigen::Vector2d at = chart.at(point->s, point->p95);
      context->line_to(at.x(), at.y());
    }
    set_colour(context, profile.colour);
    context->set_line_width(kRimWidth);
    context->stroke();
    begin = std::find_if(end, profile.errors.end(), has_band);
  }
}

void draw_mean(const Context& context, const Chart& chart, const ErrorProfile& profile) {
  std::vector<Eigen::Vector2d> means;
  for (const ErrorPoint& point : profile.errors) means.emplace_back(point.s, point.mean);
  draw_curve(context, chart, means, profile.colour, profile.style);
}

void draw_key_line(const Context& context, const Eigen::Vector2d& left, const ErrorProfile& profile, double widest) {
  const double right = left.x() + kSampleLength;
  set_colour(context, profile.colour, kBandOpacity);
  add_rectangle(context, {left.x(), left.y() - kSampleBand, kSampleLength, kSampleBand});
  context->fill();
  fill_rectangle(context, {left.x(), left.y() - kSampleBand, kSampleLength, kRimWidth}, profile.colour);
  context->move_to(left.x(), left.y());
  context->line_to(right, left.y());
  stroke_curve(context, profile.colour, profile.style);
  draw_text(context, profile.label, {right + 14.0, left.y()}, {.anchor = {0.0, 0.5}, .widest = widest - kSampleLength - 14.0});
}

void draw_errors(const Context& context, const Chart& chart, std::span<const ErrorProfile> profiles, const ErrorProfileOptions& options) {
  draw_thresholds_of_y(context, chart, options.axis.thresholds);
  for (const ErrorProfile& profile : profiles) draw_band(context, chart, profile);
  for (const LineStyle style : {LineStyle::solid, LineStyle::dashed}) {
    for (const ErrorProfile& profile : profiles) {
      if (profile.style == style) draw_mean(context, chart, profile);
    }
  }
}

}  // namespace

void draw_error_profiles(std::span<const ErrorProfile> profiles, const ErrorProfileOptions& options, const std::filesystem::path& file) {
  const std::vector<DrawnPath> paths = paths_with_alpha(profiles);
  const double key_top = kMargin + (options.title.empty() ? 0.0 : kTitleHeight);
  const double top = key_top + (static_cast<double>(profiles.size()) + 1.0) * kKeyPitch + kKeyGap;
  const double longest = longest_of(profiles, paths);
  const Chart chart{{kLeft, top, kFrameWidth, kFrameHeight}, {0.0, longest}, span_of(errors_of(profiles), options.axis)};
  const Rectangle panel{kLeft, chart.frame.bottom() + kPanelGap, kFrameWidth, profile_height(paths.size())};
  const double bottom = paths.empty() ? chart.frame.bottom() : panel.bottom();
  const Page page(chart.frame.right() + kMapLegendWidth + kMargin, bottom + kBelowFrame + kMargin);
  const Context& context = page.context();

  const double widest = kFrameWidth + kMapLegendWidth;
  draw_text(context, options.title, {kLeft, kMargin}, {.size = kTitleSize, .weight = Weight::bold, .anchor = {0.0, 0.0}, .widest = widest});
  double line = key_top + 0.5 * kKeyPitch;
  for (const ErrorProfile& profile : profiles) {
    draw_key_line(context, {kLeft, line}, profile, widest);
    line += kKeyPitch;
  }
  draw_note(context, "line: mean of the drives, band: up to their 95th percentile", {kLeft, line}, {0.0, 0.5});
  draw_errors(context, chart, profiles, options);
  if (paths.empty()) {
    draw_chart(context, chart, {"distance along the path [m]", options.axis.name});
  } else {
    draw_upper_chart(context, chart, options.axis.name);
    draw_profiles(context, panel, paths, longest, options.risk);
  }
  page.save(file);
}

}  // namespace alignability
