// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/heading_strip.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include "core/pose.hpp"
#include "core/range.hpp"
#include "pictures/axes.hpp"
#include "pictures/map_layers.hpp"
#include "pictures/text.hpp"

namespace alignability::detail {
namespace {

constexpr std::size_t kMostColumns = 4;
constexpr double kAbove = 12.0;
constexpr double kGap = 20.0;
constexpr double kLabelHeight = 40.0;

std::size_t columns(std::size_t maps) { return std::min(maps, kMostColumns); }
std::size_t rows(std::size_t maps) { return (maps + columns(maps) - 1) / columns(maps); }

// Of a small map to the view.
double share(const View& view, std::size_t maps) {
  const auto across = static_cast<double>(columns(maps));
  return (view.frame.width - (across - 1.0) * kGap) / (across * view.frame.width);
}

double row_height(const View& view, std::size_t maps) { return kLabelHeight + share(view, maps) * view.frame.height + kGap; }

void draw_arrow(const Context& context, const Eigen::Vector2d& middle, double yaw) {
  constexpr double kHalf = 12.0, kHead = 9.0;
  const Eigen::Vector2d along(std::cos(yaw), -std::sin(yaw));  // y goes down
  const Eigen::Vector2d aside(-along.y(), along.x());
  const Eigen::Vector2d tip = middle + kHalf * along, tail = middle - kHalf * along, neck = tip - kHead * along;
  set_colour(context, kInk);
  context->set_line_width(3.0);
  context->move_to(tail.x(), tail.y());
  context->line_to(neck.x(), neck.y());
  context->stroke();
  for (const Eigen::Vector2d& corner : {tip, Eigen::Vector2d(neck + 0.6 * kHead * aside), Eigen::Vector2d(neck - 0.6 * kHead * aside)}) {
    context->line_to(corner.x(), corner.y());
  }
  context->close_path();
  context->fill();
}

}  // namespace

double strip_height(const View& view, std::size_t maps) { return kAbove + static_cast<double>(rows(maps)) * row_height(view, maps); }

View small_view(const View& view, std::size_t number, std::size_t maps) {
  const double size = share(view, maps);
  const auto column = static_cast<double>(number % columns(maps)), row = static_cast<double>(number / columns(maps));
  View small = view;
  small.scale = size * view.scale;
  small.frame = {std::round(view.frame.left + column * (size * view.frame.width + kGap)),
                 std::round(view.frame.bottom() + kBelowFrame + kAbove + row * row_height(view, maps) + kLabelHeight),
                 std::round(size * view.frame.width), std::round(size * view.frame.height)};
  return small;
}

void draw_heading_strip(const Context& context, const View& view, std::span<const Grid<float>* const> headings,
                        const OccupancyMap& occupancy) {
  for (std::size_t k = 0; k < headings.size(); ++k) {
    const View small = small_view(view, k, headings.size());
    const double turn = static_cast<double>(k) / static_cast<double>(headings.size());
    const Eigen::Vector2d label(small.frame.left, small.frame.top - 0.5 * kLabelHeight);
    draw_arrow(context, label + Eigen::Vector2d(16.0, 0.0), 2.0 * std::numbers::pi * turn);
    draw_text(context, to_text(std::round(3600.0 * turn) / 10.0) + "°", label + Eigen::Vector2d(42.0, 0.0), {.anchor = {0.0, 0.5}});
    draw_map(context, small, *headings[k], alignability_scale(Tone::full), occupancy, Tone::full);
    outline_rectangle(context, small.frame, kInk);
  }
}

}  // namespace alignability::detail
