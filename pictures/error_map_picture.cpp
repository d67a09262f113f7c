// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/error_map_picture.hpp"

#include <stdexcept>

#include "core/range.hpp"
#include "pictures/axes.hpp"
#include "pictures/legend.hpp"
#include "pictures/map_layers.hpp"
#include "pictures/map_layout.hpp"

namespace alignability {
namespace {

using namespace detail;

constexpr double kRouteWidth = 1.6;
constexpr double kRouteCasing = 0.8;  // white on either side
constexpr Colour kRouteColour = colour_from_hex(0x0067a5);

// The line that the context holds, with a casing to be seen on any colour.
void stroke_route(const Context& context) {
  context->set_line_join(Cairo::Context::LineJoin::ROUND);
  set_colour(context, kWhite);
  context->set_line_width(kRouteWidth + 2.0 * kRouteCasing);
  context->stroke_preserve();
  set_colour(context, kRouteColour);
  context->set_line_width(kRouteWidth);
  context->stroke();
}

void draw_route(const Context& context, const View& view, std::span<const Pose2> route) {
  context->save();
  add_rectangle(context, view.frame);
  context->clip();
  bool gap = true;
  for (const Pose2& pose : route) {
    const bool known = pose.position().allFinite();
    const Eigen::Vector2d at = view.to_pixel(pose.position());
    if (known) gap ? context->move_to(at.x(), at.y()) : context->line_to(at.x(), at.y());
    gap = !known;
  }
  stroke_route(context);
  context->restore();
}

Swatch route_swatch() {
  return {"driven route", [](const Context& context, const Rectangle& patch) {
            const double middle = patch.top + 0.5 * patch.height;
            context->move_to(patch.left, middle);
            context->line_to(patch.right(), middle);
            stroke_route(context);
          }};
}

MapLegend legend_of(const ErrorMapOptions& options, const ColourScale& colour_of, std::span<const Pose2> route) {
  MapLegend legend{.name = options.label,
                   .colour_of = colour_of,
                   .limit = options.limit,
                   .end = ScaleEnd::open,
                   .thresholds = {},
                   .swatches = map_swatches("not driven", Tone::pale)};
  if (!route.empty()) legend.swatches.push_back(route_swatch());
  return legend;
}

}  // namespace

void draw_error_map(const Grid<float>& error, const OccupancyMap& occupancy, std::span<const Pose2> route, const ErrorMapOptions& options,
                    const std::filesystem::path& file) {
  if (!kPositive.contains(options.limit)) throw std::invalid_argument("the limit of an error map must be positive");
  const MapLayout layout = lay_out(view_of(error.geometry(), occupancy), options.title, 0);
  const Page page(layout.width, layout.bottom + kMargin);
  const Context& context = page.context();
  const ColourScale colour_of = [limit = options.limit](double value) { return error_colour(value / limit); };

  draw_title(context, layout, options.title);
  draw_map(context, layout.view, error, colour_of, occupancy, Tone::pale);
  draw_route(context, layout.view, route);
  draw_axes(context, layout.view, kMapAxes);
  draw_scale_bar(context, layout.view);
  draw_map_legend(context, layout.legend, legend_of(options, colour_of, route));
  page.save(file);
}

}  // namespace alignability
