// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/trade_off_picture.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/range.hpp"
#include "pictures/chart.hpp"
#include "pictures/map_layout.hpp"
#include "pictures/path_picture.hpp"
#include "pictures/text.hpp"

namespace alignability {
namespace {

using namespace detail;

constexpr double kDot = 6.5;

// Lengths differ by little, so their axis starts near the shortest; not so near that a centimetre looks like a detour.
Span span_of_lengths(std::span<const TradeOffPoint> points) {
  if (points.empty()) return {};
  const auto [shortest, longest] = std::ranges::minmax(points, {}, &TradeOffPoint::length);
  const double margin = std::max(0.1 * (longest.length - shortest.length), 0.02 * longest.length) + 1e-3;
  return {std::max(0.0, shortest.length - margin), longest.length + 2.0 * margin};
}

double most_blind(std::span<const TradeOffPoint> points) {
  double most = 0.0;
  for (const TradeOffPoint& point : points) most = std::max(most, point.blind_length);
  return most;
}

// A dot and what its label says, for the weights whose dots lie upon each other.
struct Mark {
  Eigen::Vector2d at;
  std::string weights;
};

std::vector<Mark> marks_of(const Chart& chart, std::span<const TradeOffPoint> points) {
  std::vector<Mark> marks;
  for (const TradeOffPoint& point : points) {
    const Eigen::Vector2d at = chart.at(point.length, point.blind_length);
    const auto same = std::ranges::find_if(marks, [&](const Mark& mark) { return (mark.at - at).norm() < 2.5 * kDot; });
    if (same == marks.end()) {
      marks.push_back({at, "w = " + to_text(point.weight)});
    } else {
      same->weights += ", " + to_text(point.weight);
    }
  }
  return marks;
}

void draw_curve(const Context& context, const Chart& chart, std::span<const TradeOffPoint> points) {
  context->begin_new_path();
  for (const TradeOffPoint& point : points) {
    const Eigen::Vector2d at = chart.at(point.length, point.blind_length);
    context->line_to(at.x(), at.y());
  }
  set_colour(context, kRiskAwareColour);
  context->set_line_width(2.5);
  context->stroke();
}

// The label stands to the right of its dot, or to the left where the frame ends.
void draw_mark(const Context& context, const Rectangle& frame, const Mark& mark) {
  context->begin_new_path();
  context->arc(mark.at.x(), mark.at.y(), kDot, 0.0, 2.0 * std::numbers::pi);
  set_colour(context, kRiskAwareColour);
  context->fill();
  const double aside = 12.0;
  const bool fits = mark.at.x() + aside + text_width(mark.weights, kLabelSize, Weight::normal) < frame.right();
  draw_rimmed_text(context, mark.weights, mark.at + Eigen::Vector2d(fits ? aside : -aside, -aside), {.anchor = {fits ? 0.0 : 1.0, 1.0}});
}

}  // namespace

void draw_trade_off(std::span<const TradeOffPoint> points, const std::string& title, const std::filesystem::path& file) {
  const Chart chart{{90.0, 90.0, 720.0, 460.0}, span_of_lengths(points), span_from_zero(most_blind(points))};
  const Page page(chart.frame.right() + 40.0, chart.frame.bottom() + kBelowFrame + kMargin);
  const Context& context = page.context();
  draw_text(context, title, {chart.frame.left, 50.0},
            {.size = kTitleSize, .weight = Weight::bold, .anchor = {0.0, 1.0}, .widest = chart.frame.width});
  draw_chart(context, chart, {"length of the path [m]", "driven blind [m]"});
  draw_curve(context, chart, points);
  for (const Mark& mark : marks_of(chart, points)) draw_mark(context, chart.frame, mark);
  page.save(file);
}

}  // namespace alignability
