// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/path_layer.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "pictures/blind_stretches.hpp"
#include "pictures/colour_map.hpp"
#include "pictures/text.hpp"

namespace alignability::detail {
namespace {

using Polyline = std::vector<Eigen::Vector2d>;

constexpr double kSolidWidth = 6.0;
constexpr double kDashedWidth = 4.0;
constexpr double kCasing = 2.5;  // white on either side of a line
constexpr double kHaloWidth = 25.0;
constexpr double kSampleHaloWidth = 21.0;
constexpr double kHaloRim = 2.0;
constexpr double kMarkerRadius = 10.0;
const std::vector<double> kDashes = {15.0, 9.0};

double width_of(LineStyle style) { return style == LineStyle::solid ? kSolidWidth : kDashedWidth; }

void stroke(const Context& context, const Polyline& line, double width, const Colour& colour) {
  context->begin_new_path();
  for (const Eigen::Vector2d& corner : line) context->line_to(corner.x(), corner.y());
  context->set_line_width(width);
  set_colour(context, colour);
  context->stroke();
}

void stroke_path(const Context& context, const Polyline& line, const DrawnPath& path) {
  if (path.style == LineStyle::dashed) context->set_dash(kDashes, 0.0);
  stroke(context, line, width_of(path.style), path.colour);
  context->unset_dash();
}

void stroke_halo(const Context& context, const Polyline& line) {
  stroke(context, line, kHaloWidth + 2.0 * kHaloRim, kWhite);
  stroke(context, line, kHaloWidth, kBlind);
}

Polyline to_pixels(const View& view, const Polyline& points) {
  Polyline pixels;
  for (const Eigen::Vector2d& point : points) pixels.push_back(view.to_pixel(point));
  return pixels;
}

Polyline line_of(const View& view, const DrawnPath& path) {
  Polyline line;
  for (const Pose2& pose : path.poses) line.push_back(view.to_pixel(pose.position()));
  return line;
}

std::vector<Polyline> blind_lines(const View& view, const DrawnPath& path, const RiskOptions& risk) {
  std::vector<Polyline> lines;
  for (const Stretch& stretch : blind_stretches(path.profile, risk)) {
    const double length = path.profile.back().s;
    lines.push_back(to_pixels(view, part_of(path.poses, stretch.from / length, stretch.to / length)));
  }
  return lines;
}

void draw_lines(const Context& context, const View& view, std::span<const DrawnPath> paths, const RiskOptions& risk) {
  context->set_line_join(Cairo::Context::LineJoin::ROUND);
  for (const DrawnPath& path : paths) {
    for (const Polyline& line : blind_lines(view, path, risk)) stroke_halo(context, line);
  }
  for (const DrawnPath& path : paths) stroke(context, line_of(view, path), width_of(path.style) + 2.0 * kCasing, kWhite);
  for (const LineStyle style : {LineStyle::solid, LineStyle::dashed}) {
    for (const DrawnPath& path : paths) {
      if (path.style == style) stroke_path(context, line_of(view, path), path);
    }
  }
}

void draw_disc(const Context& context, const Eigen::Vector2d& at, double radius, const Colour& colour) {
  context->begin_new_path();
  context->arc(at.x(), at.y(), radius, 0.0, 2.0 * std::numbers::pi);
  set_colour(context, colour);
  context->fill();
}

// The robot's outline at a pose, in pixels.
Polyline outline_at(const View& view, const Pose2& pose, const PathPictureOptions& robot) {
  Polyline outline;
  for (const Eigen::Vector2d& corner : robot.footprint) {
    outline.push_back(view.to_pixel(pose.position() + Eigen::Rotation2Dd(pose.yaw) * corner));
  }
  constexpr int kCorners = 64;
  for (int i = 0; outline.size() < kCorners && robot.footprint.empty(); ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kCorners;
    outline.push_back(view.to_pixel(pose.position() + robot.robot_radius * Eigen::Vector2d(std::cos(angle), std::sin(angle))));
  }
  return outline;
}

// How far the robot's outline reaches from its pose [px].
double reach_of(const View& view, const PathPictureOptions& robot) {
  double reach = robot.footprint.empty() ? robot.robot_radius : 0.0;
  for (const Eigen::Vector2d& corner : robot.footprint) reach = std::max(reach, corner.norm());
  return reach * view.scale;
}

void draw_footprint(const Context& context, const Polyline& outline) {
  context->begin_new_path();
  for (const Eigen::Vector2d& corner : outline) context->line_to(corner.x(), corner.y());
  context->close_path();
  set_colour(context, kWhite, 0.55);
  context->fill_preserve();
  set_colour(context, kInk);
  context->set_line_width(1.5);
  context->stroke();
}

void draw_heading(const Context& context, const Eigen::Vector2d& at, double yaw) {
  const Eigen::Vector2d ahead(std::cos(yaw), -std::sin(yaw));
  const Eigen::Vector2d aside(-ahead.y(), ahead.x());
  const Eigen::Vector2d foot = at + 1.1 * kMarkerRadius * ahead;
  const Eigen::Vector2d tip = at + 3.2 * kMarkerRadius * ahead;
  const Polyline corners = {foot + 0.65 * kMarkerRadius * aside, tip, foot - 0.65 * kMarkerRadius * aside};
  context->begin_new_path();
  for (const Eigen::Vector2d& corner : corners) context->line_to(corner.x(), corner.y());
  context->close_path();
  set_colour(context, kWhite);
  context->set_line_width(4.0);
  context->stroke_preserve();
  set_colour(context, kInk);
  context->fill();
}

// How many points of the paths a label would lie on; more than any number of them where it would leave the frame.
double obstruction(const View& view, const Rectangle& box, std::span<const Polyline> lines) {
  const Rectangle& frame = view.frame;
  const bool inside = box.left > frame.left && box.right() < frame.right() && box.top > frame.top && box.bottom() < frame.bottom();
  double covered = inside ? 0.0 : 1e9;
  for (const Polyline& line : lines) {
    for (const Eigen::Vector2d& point : line) {
      covered += point.x() > box.left && point.x() < box.right() && point.y() > box.top && point.y() < box.bottom() ? 1.0 : 0.0;
    }
  }
  return covered;
}

// The paths in steps short enough that none jumps over a label.
std::vector<Polyline> sampled(const View& view, std::span<const DrawnPath> paths) {
  constexpr int kSamples = 1000;
  std::vector<Polyline> lines;
  for (const DrawnPath& path : paths) {
    Polyline line;
    for (int i = 0; i < kSamples; ++i) {
      const Polyline step = part_of(path.poses, static_cast<double>(i) / kSamples, (i + 1.0) / kSamples);
      if (!step.empty()) line.push_back(view.to_pixel(step.front()));
    }
    lines.push_back(line);
  }
  return lines;
}

struct Marker {
  std::string name;
  Pose2 pose;
  Colour middle;
};

void draw_marker(const Context& context, const View& view, const Marker& marker, const PathPictureOptions& robot) {
  const Eigen::Vector2d at = view.to_pixel(marker.pose.position());
  if (reach_of(view, robot) > kMarkerRadius) draw_footprint(context, outline_at(view, marker.pose, robot));
  draw_heading(context, at, marker.pose.yaw);
  draw_disc(context, at, kMarkerRadius + 2.0, kWhite);
  draw_disc(context, at, kMarkerRadius, kInk);
  draw_disc(context, at, kMarkerRadius - 3.5, kWhite);
  draw_disc(context, at, kMarkerRadius - 6.0, marker.middle);
}

// Below, above, right or left of the marker, where the label hides least.
void draw_marker_label(const Context& context, const View& view, const Marker& marker, std::span<const Polyline> lines,
                       const PathPictureOptions& robot) {
  const double width = text_width(marker.name, kLabelSize, Weight::bold) + 8.0;
  const double height = capital_height(kLabelSize) + 10.0;
  const double away = std::max(3.3 * kMarkerRadius, reach_of(view, robot) + 4.0);
  const Eigen::Vector2d at = view.to_pixel(marker.pose.position());
  const std::array<Eigen::Vector2d, 4> centers = {
      at + Eigen::Vector2d(0.0, away + 0.5 * height), at - Eigen::Vector2d(0.0, away + 0.5 * height),
      at + Eigen::Vector2d(away + 0.5 * width, 0.0), at - Eigen::Vector2d(away + 0.5 * width, 0.0)};
  const auto obstructed = [&](const Eigen::Vector2d& center) {
    return obstruction(view, {center.x() - 0.5 * width, center.y() - 0.5 * height, width, height}, lines);
  };
  const auto best = std::ranges::min_element(centers, {}, obstructed);
  draw_rimmed_text(context, marker.name, *best, {.weight = Weight::bold, .anchor = {0.5, 0.5}});
}

}  // namespace

void draw_path_layer(const Context& context, const View& view, std::span<const DrawnPath> paths, const PathPictureOptions& options) {
  context->save();
  add_rectangle(context, view.frame);
  context->clip();
  draw_lines(context, view, paths, options.risk);
  std::vector<Marker> markers;
  if (options.start) markers.push_back({"start", *options.start, kWhite});
  if (options.goal) markers.push_back({"goal", *options.goal, kInk});
  const std::vector<Polyline> lines = sampled(view, paths);
  for (const Marker& marker : markers) draw_marker(context, view, marker, options);
  for (const Marker& marker : markers) draw_marker_label(context, view, marker, lines, options);
  context->restore();
}

void draw_path_sample(const Context& context, const Eigen::Vector2d& left_middle, const DrawnPath& path) {
  stroke_path(context, {left_middle, left_middle + Eigen::Vector2d(kSampleLength, 0.0)}, path);
}

void draw_blind_sample(const Context& context, const Eigen::Vector2d& left_middle) {
  const Polyline line = {left_middle, left_middle + Eigen::Vector2d(kSampleLength, 0.0)};
  stroke(context, line, kSampleHaloWidth, kBlind);
  stroke(context, line, kSolidWidth + 2.0 * kCasing, kWhite);
}

}  // namespace alignability::detail
