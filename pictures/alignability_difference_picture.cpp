// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/alignability_difference_picture.hpp"

#include <algorithm>
#include <cmath>

#include "pictures/axes.hpp"
#include "pictures/legend.hpp"
#include "pictures/map_layers.hpp"
#include "pictures/map_layout.hpp"

namespace alignability {
namespace {

using namespace detail;

constexpr double kFrameWidth = 3.0;

void stroke_inside(const Context& context, const Rectangle& cell) {
  const double inset = 0.5 * kFrameWidth;
  add_rectangle(context, {cell.left + inset, cell.top + inset, cell.width - kFrameWidth, cell.height - kFrameWidth});
  set_colour(context, kInk);
  context->set_line_width(kFrameWidth);
  context->stroke();
}

void frame_lower_cells(const Context& context, const View& view, const MapComparison& comparison, const GridGeometry& cells) {
  for (const ComparedCell& at : comparison.cells) {
    if (!at.is_lower) continue;
    const Eigen::Vector2d corner = cells.corner(at.cell);
    stroke_inside(context, view.to_pixels({corner, corner + Eigen::Vector2d::Constant(cells.resolution)}));
  }
}

double rounded_limit(const MapComparison& comparison) {
  constexpr double kStep = 0.1;
  return kStep * std::max(1.0, std::ceil(comparison.magnitude.max / kStep - 1e-9));
}

MapLegend legend_of(const ColourScale& colour_of, double limit) {
  MapLegend legend{.name = "change of α",
                   .colour_of = colour_of,
                   .from = -limit,
                   .limit = limit,
                   .end = ScaleEnd::closed,
                   .thresholds = {},
                   .swatches = map_swatches("not in both", Tone::full)};
  legend.swatches.push_back({"lower", [](const Context& context, const Rectangle& patch) { stroke_inside(context, patch); }});
  return legend;
}

}  // namespace

void draw_alignability_difference(const MapComparison& comparison, const GridGeometry& cells, const OccupancyMap& occupancy,
                                  const std::string& title, const std::filesystem::path& file) {
  const MapLayout layout = lay_out(view_of(cells, occupancy), title, 0);
  const Page page(layout.width, layout.bottom + kMargin);
  const Context& context = page.context();
  const double limit = rounded_limit(comparison);
  const ColourScale colour_of = [limit](double difference) { return difference_colour(difference / limit); };

  draw_title(context, layout, title);
  draw_map(context, layout.view, difference_grid(comparison, cells), colour_of, occupancy, Tone::full);
  frame_lower_cells(context, layout.view, comparison, cells);
  draw_axes(context, layout.view, kMapAxes);
  draw_scale_bar(context, layout.view);
  draw_map_legend(context, layout.legend, legend_of(colour_of, limit));
  page.save(file);
}

}  // namespace alignability
