// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/scan_picture.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "core/range.hpp"
#include "pictures/axes.hpp"
#include "pictures/map_layout.hpp"
#include "pictures/text.hpp"

namespace alignability {
namespace {

using namespace detail;

constexpr double kLongerSide = 1000.0;
constexpr double kBorder = 1.04;
constexpr double kLeastAspect = 0.6;
constexpr double kPointSide = 2.5;
constexpr double kAxisLength = 46.0;
constexpr double kArrowShare = 0.16;  // of the longer side, for a horizontal direction
constexpr double kSteepBelow = 0.15;  // share of a unit vector that is seen from above
constexpr double kLegendWidth = 240.0;
constexpr double kPitch = 30.0;
constexpr std::size_t kNamedPlanes = 12;
constexpr Colour kNoPlane = colour_from_hex(0xa8a8a8);
constexpr Colour kWeak = kBlind;

struct Plane {
  int number;
  std::size_t points;
};

// The largest first, points of no plane not among them.
std::vector<Plane> planes_of(std::span<const int> plane_of_point) {
  std::map<int, std::size_t> counts;
  for (const int plane : plane_of_point) ++counts[plane];
  std::vector<Plane> planes;
  for (const auto& [number, points] : counts) {
    if (number >= 0) planes.push_back({number, points});
  }
  std::ranges::stable_sort(planes, std::ranges::greater{}, &Plane::points);
  return planes;
}

Colour colour_of(int plane) { return plane < 0 ? kNoPlane : category_colour(static_cast<std::size_t>(plane)); }

// Half the sides of a rectangle about the sensor that holds all points and is not too slim for the legend.
Eigen::Vector2d half_extent(std::span<const Eigen::Vector3f> points) {
  Eigen::Vector2d far = Eigen::Vector2d::Zero();
  for (const Eigen::Vector3f& point : points) {
    if (point.allFinite()) far = far.cwiseMax(point.head<2>().cwiseAbs().cast<double>());
  }
  const double longer = far.maxCoeff() > 0.0 ? kBorder * far.maxCoeff() : 1.0;
  return (kBorder * far).cwiseMax(kLeastAspect * longer).cwiseMin(longer);
}

// The points of no plane lowest, then the planes from the largest to the smallest, so that a floor hides no wall.
std::vector<std::size_t> drawing_order(std::span<const int> plane_of_point, std::span<const Plane> planes) {
  std::map<int, std::size_t> ranks;
  for (std::size_t i = 0; i < planes.size(); ++i) ranks[planes[i].number] = i + 1;
  std::vector<std::size_t> order(plane_of_point.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return plane_of_point[i] < 0 ? 0 : ranks.at(plane_of_point[i]); });
  return order;
}

void draw_points(const Context& context, const View& view, std::span<const Eigen::Vector3f> points, std::span<const int> plane_of_point,
                 std::span<const Plane> planes) {
  context->save();
  add_rectangle(context, view.frame);
  context->clip();
  for (const std::size_t i : drawing_order(plane_of_point, planes)) {
    if (!points[i].allFinite()) continue;
    const Eigen::Vector2d at = view.to_pixel(points[i].head<2>().cast<double>());
    fill_rectangle(context, {at.x() - 0.5 * kPointSide, at.y() - 0.5 * kPointSide, kPointSide, kPointSide}, colour_of(plane_of_point[i]));
  }
  context->restore();
}

// A shaft with a head at `to`, cased in white.
void draw_arrow(const Context& context, const Eigen::Vector2d& from, const Eigen::Vector2d& to, double width, const Colour& colour) {
  const Eigen::Vector2d along = (to - from).normalized();
  const Eigen::Vector2d aside(-along.y(), along.x());
  const Eigen::Vector2d neck = to - 3.6 * width * along;
  const auto trace = [&] {
    context->begin_new_path();
    for (const Eigen::Vector2d& corner : {Eigen::Vector2d(from + 0.5 * width * aside), Eigen::Vector2d(neck + 0.5 * width * aside),
                                          Eigen::Vector2d(neck + 1.6 * width * aside), to, Eigen::Vector2d(neck - 1.6 * width * aside),
                                          Eigen::Vector2d(neck - 0.5 * width * aside), Eigen::Vector2d(from - 0.5 * width * aside)}) {
      context->line_to(corner.x(), corner.y());
    }
    context->close_path();
  };
  trace();
  set_colour(context, kWhite);
  context->set_line_width(5.0);
  context->stroke();
  trace();
  set_colour(context, colour);
  context->fill();
}

void draw_sensor(const Context& context, const View& view) {
  const Eigen::Vector2d at = view.to_pixel(Eigen::Vector2d::Zero());
  const Eigen::Vector2d x_end = at + Eigen::Vector2d(kAxisLength, 0.0);
  const Eigen::Vector2d y_end = at - Eigen::Vector2d(0.0, kAxisLength);
  draw_arrow(context, at, x_end, 3.5, kInk);
  draw_arrow(context, at, y_end, 3.5, kInk);
  draw_rimmed_text(context, "x", x_end + Eigen::Vector2d(-6.0, 14.0), {.weight = Weight::bold, .anchor = {0.5, 0.0}});
  draw_rimmed_text(context, "y", y_end + Eigen::Vector2d(-14.0, 6.0), {.weight = Weight::bold, .anchor = {1.0, 0.5}});
  context->arc(at.x(), at.y(), 7.0, 0.0, 2.0 * std::numbers::pi);
  set_colour(context, kWhite);
  context->fill_preserve();
  set_colour(context, kInk);
  context->set_line_width(3.0);
  context->stroke();
}

double seen_from_above(const Eigen::Vector3d& direction) { return direction.normalized().head<2>().norm(); }

void draw_weakest_direction(const Context& context, const View& view, const Eigen::Vector3d& direction) {
  if (!(seen_from_above(direction) >= kSteepBelow)) return;
  const Eigen::Vector3d unit = direction.normalized();
  const Eigen::Vector2d reach = kArrowShare * kLongerSide * Eigen::Vector2d(unit.x(), -unit.y());
  const Eigen::Vector2d at = view.to_pixel(Eigen::Vector2d::Zero());
  draw_arrow(context, at, at + reach, 6.0, kWeak);
  draw_arrow(context, at, at - reach, 6.0, kWeak);
}

// Lines of text under each other in the legend.
class Column {
 public:
  Column(const Context& context, const Rectangle& area)
      : context_(context), area_(area), middle_(area.top + 0.5 * capital_height(kLabelSize)) {}

  void write(const std::string& text) {
    draw_text(context_, text, {area_.left, middle_}, {.anchor = {0.0, 0.5}, .widest = area_.width});
    middle_ += kPitch;
  }
  void write(const Colour& swatch, const std::string& text) {
    fill_rectangle(context_, {area_.left, std::round(middle_ - 7.0), 14.0, 14.0}, swatch);
    draw_text(context_, text, {area_.left + 24.0, middle_}, {.size = kTickSize, .anchor = {0.0, 0.5}, .widest = area_.width - 24.0});
    middle_ += kPitch;
  }
  void skip() { middle_ += 0.5 * kPitch; }

 private:
  Context context_;
  Rectangle area_;
  double middle_;
};

std::string counted(std::size_t count, const std::string& things) { return std::to_string(count) + " " + things; }

void draw_legend(const Context& context, const Rectangle& area, std::span<const Eigen::Vector3f> points,
                 std::span<const int> plane_of_point, std::span<const Plane> planes, const ScanPictureOptions& options) {
  Column column(context, area);
  for (const std::string& line : options.lines) column.write(line);
  if (!options.lines.empty()) column.skip();
  if (options.weakest_direction) {
    const bool steep = !(seen_from_above(*options.weakest_direction) >= kSteepBelow);
    column.write(kWeak, steep ? "weakest: vertical" : "weakest direction");
    column.skip();
  }
  for (std::size_t i = 0; i < std::min(planes.size(), kNamedPlanes); ++i) {
    column.write(colour_of(planes[i].number), "plane " + std::to_string(planes[i].number) + ": " + counted(planes[i].points, "points"));
  }
  if (planes.size() > kNamedPlanes) column.write("and " + counted(planes.size() - kNamedPlanes, "smaller planes"));
  std::size_t unassigned = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (plane_of_point[i] < 0 && points[i].allFinite()) ++unassigned;
  }
  column.write(kNoPlane, "no plane: " + counted(unassigned, "points"));
}

}  // namespace

void draw_scan(std::span<const Eigen::Vector3f> points, std::span<const int> plane_of_point, const ScanPictureOptions& options,
               const std::filesystem::path& png) {
  if (points.size() != plane_of_point.size()) throw std::invalid_argument("a scan's picture needs one plane per point");
  if (options.range && !kPositive.contains(*options.range)) throw std::invalid_argument("a scan's picture needs a positive range");
  const Eigen::Vector2d half = options.range ? Eigen::Vector2d(*options.range, *options.range) : half_extent(points);
  const MapLayout layout = lay_out(view_of({-half, half}, 0.5 * kLongerSide / half.maxCoeff()), options.title, 0, kLegendWidth);
  const std::vector<Plane> planes = planes_of(plane_of_point);
  const Page page(layout.width, layout.bottom + kMargin);
  const Context& context = page.context();

  draw_title(context, layout, options.title);
  draw_points(context, layout.view, points, plane_of_point, planes);
  if (options.weakest_direction) draw_weakest_direction(context, layout.view, *options.weakest_direction);
  draw_sensor(context, layout.view);
  draw_axes(context, layout.view, {"x, forward [m]", "y, left [m]"});
  draw_scale_bar(context, layout.view);
  draw_legend(context, layout.legend, points, plane_of_point, planes, options);
  page.save(png);
}

}  // namespace alignability
