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
#include "pictures/map_layers.hpp"
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
constexpr double kAxisNameGap = 18.0;
constexpr double kArrowShare = 0.16;  // of the longer side, for a horizontal direction
constexpr double kSteepBelow = 0.15;  // share of a unit vector that is seen from above
constexpr double kLegendWidth = 240.0;
constexpr double kLabelledLegendWidth = 340.0;
constexpr double kPitch = 30.0;
constexpr double kPaleness = 0.5;
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

// By number: 1 the largest, 0 none.
std::map<int, std::size_t> ranks_of(std::span<const Plane> planes) {
  std::map<int, std::size_t> ranks{{-1, 0}};
  for (std::size_t i = 0; i < planes.size(); ++i) ranks[planes[i].number] = i + 1;
  return ranks;
}

Colour colour_of(std::size_t rank) {
  if (rank == 0) return kNoPlane;
  const Colour colour = category_colour(rank - 1);
  return rank <= kNamedPlanes ? colour : mixed(colour, kWhite, kPaleness);
}

// A scan as it is drawn: its points and its sensor in the frame of the picture.
struct Drawing {
  std::vector<Eigen::Vector3d> points;
  std::vector<std::size_t> rank_of_point;
  std::vector<Plane> planes;
  Eigen::Isometry3d T_picture_lidar;

  Eigen::Vector2d sensor() const { return T_picture_lidar.translation().head<2>(); }
};

// Half the sides of a rectangle about the sensor that holds all points and is not too slim for the legend.
Eigen::Vector2d half_extent(const Drawing& drawing) {
  Eigen::Vector2d far = Eigen::Vector2d::Zero();
  for (const Eigen::Vector3d& point : drawing.points) {
    if (point.allFinite()) far = far.cwiseMax((point.head<2>() - drawing.sensor()).cwiseAbs());
  }
  const double longer = far.maxCoeff() > 0.0 ? kBorder * far.maxCoeff() : 1.0;
  return (kBorder * far).cwiseMax(kLeastAspect * longer).cwiseMin(longer);
}

Drawing drawing_of(std::span<const Eigen::Vector3f> points, std::span<const int> plane_of_point, const ScanPictureOptions& options) {
  Drawing drawing;
  drawing.T_picture_lidar = options.T_map_lidar.value_or(Eigen::Isometry3d::Identity());
  for (const Eigen::Vector3f& point : points) drawing.points.emplace_back(drawing.T_picture_lidar * point.cast<double>());
  drawing.planes = planes_of(plane_of_point);
  const std::map<int, std::size_t> ranks = ranks_of(drawing.planes);
  for (const int plane : plane_of_point) drawing.rank_of_point.push_back(ranks.at(std::max(plane, -1)));
  return drawing;
}

// A square, once it is stroked.
void add_point(const Context& context, const View& view, const Eigen::Vector3d& point) {
  if (!point.allFinite()) return;
  const Eigen::Vector2d at = view.to_pixel(point.head<2>());
  context->move_to(at.x() - 0.5 * kPointSide, at.y());
  context->line_to(at.x() + 0.5 * kPointSide, at.y());
}

// The points of no plane lowest, then the planes from the largest to the smallest, so that a floor hides no wall.
void draw_points(const Context& context, const View& view, const Drawing& drawing) {
  std::vector<std::size_t> order(drawing.points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return drawing.rank_of_point[i]; });
  context->save();
  add_rectangle(context, view.frame);
  context->clip();
  context->set_line_width(kPointSide);
  // The points of a plane are one stroke of as many squares: one by one, they would fill five times as much of an SVG.
  for (auto plane = order.begin(); plane != order.end();) {
    const std::size_t rank = drawing.rank_of_point[*plane];
    set_colour(context, colour_of(rank));
    for (; plane != order.end() && drawing.rank_of_point[*plane] == rank; ++plane) add_point(context, view, drawing.points[*plane]);
    context->stroke();
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

// A direction of the lidar as it looks from above, in pixels.
Eigen::Vector2d on_page(const Drawing& drawing, const Eigen::Vector3d& direction) {
  const Eigen::Vector3d turned = drawing.T_picture_lidar.linear() * direction;
  return {turned.x(), -turned.y()};
}

void draw_sensor(const Context& context, const View& view, const Drawing& drawing) {
  const Eigen::Vector2d at = view.to_pixel(drawing.sensor());
  const Eigen::Vector2d x = on_page(drawing, Eigen::Vector3d::UnitX());
  const Eigen::Vector2d y = on_page(drawing, Eigen::Vector3d::UnitY());
  const TextStyle bold{.weight = Weight::bold, .anchor = {0.5, 0.5}};
  draw_arrow(context, at, at + kAxisLength * x, 3.5, kInk);
  draw_arrow(context, at, at + kAxisLength * y, 3.5, kInk);
  draw_rimmed_text(context, "x", at + (kAxisLength - 6.0) * x - kAxisNameGap * y, bold);
  draw_rimmed_text(context, "y", at + (kAxisLength - 6.0) * y - kAxisNameGap * x, bold);
  context->arc(at.x(), at.y(), 7.0, 0.0, 2.0 * std::numbers::pi);
  set_colour(context, kWhite);
  context->fill_preserve();
  set_colour(context, kInk);
  context->set_line_width(3.0);
  context->stroke();
}

bool is_steep(const Drawing& drawing, const Eigen::Vector3d& direction) {
  return !(on_page(drawing, direction.normalized()).norm() >= kSteepBelow);
}

void draw_weakest_direction(const Context& context, const View& view, const Drawing& drawing, const Eigen::Vector3d& direction) {
  if (is_steep(drawing, direction)) return;
  const Eigen::Vector2d reach = kArrowShare * kLongerSide * on_page(drawing, direction.normalized());
  const Eigen::Vector2d at = view.to_pixel(drawing.sensor());
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

std::string label_of(const Plane& plane, std::size_t rank, const ScanPictureOptions& options) {
  if (rank < options.plane_labels.size()) return options.plane_labels[rank];
  return "plane " + std::to_string(plane.number) + ": " + counted(plane.points, "points");
}

void draw_legend(const Context& context, const Rectangle& area, const Drawing& drawing, const ScanPictureOptions& options) {
  Column column(context, area);
  for (const std::string& line : options.lines) column.write(line);
  if (!options.lines.empty()) column.skip();
  if (options.weakest_direction) {
    column.write(kWeak, is_steep(drawing, *options.weakest_direction) ? "weakest: vertical" : "weakest direction");
    column.skip();
  }
  const std::size_t planes = drawing.planes.size();
  for (std::size_t i = 0; i < std::min(planes, kNamedPlanes); ++i) {
    column.write(colour_of(i + 1), label_of(drawing.planes[i], i, options));
  }
  if (planes > kNamedPlanes) {
    const std::string smaller = "and " + counted(planes - kNamedPlanes, "smaller planes");
    column.write(colour_of(kNamedPlanes + 1), options.smaller_planes.empty() ? smaller : options.smaller_planes);
  }
  std::size_t unassigned = 0;
  for (std::size_t i = 0; i < drawing.points.size(); ++i) {
    if (drawing.rank_of_point[i] == 0 && drawing.points[i].allFinite()) ++unassigned;
  }
  column.write(kNoPlane, "no plane: " + counted(unassigned, "points"));
}

}  // namespace

void draw_scan(std::span<const Eigen::Vector3f> points, std::span<const int> plane_of_point, const ScanPictureOptions& options,
               const std::filesystem::path& file) {
  if (points.size() != plane_of_point.size()) throw std::invalid_argument("a scan's picture needs one plane per point");
  if (options.range && !kPositive.contains(*options.range)) throw std::invalid_argument("a scan's picture needs a positive range");
  const Drawing drawing = drawing_of(points, plane_of_point, options);
  const Eigen::Vector2d half = options.range ? Eigen::Vector2d(*options.range, *options.range) : half_extent(drawing);
  const WorldBox box{drawing.sensor() - half, drawing.sensor() + half};
  const MapLayout layout = lay_out(view_of(box, 0.5 * kLongerSide / half.maxCoeff()), options.title, 0,
                                   options.plane_labels.empty() ? kLegendWidth : kLabelledLegendWidth);
  const Page page(layout.width, layout.bottom + kMargin);
  const Context& context = page.context();

  draw_title(context, layout, options.title);
  if (options.T_map_lidar && options.occupancy != nullptr) draw_occupancy(context, layout.view, *options.occupancy, Tone::pale);
  draw_points(context, layout.view, drawing);
  if (options.weakest_direction) draw_weakest_direction(context, layout.view, drawing, *options.weakest_direction);
  draw_sensor(context, layout.view, drawing);
  draw_axes(context, layout.view, options.T_map_lidar ? kMapAxes : AxisNames{"x, forward [m]", "y, left [m]"});
  draw_scale_bar(context, layout.view);
  draw_legend(context, layout.legend, drawing, options);
  page.save(file);
}

}  // namespace alignability
