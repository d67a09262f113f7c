// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/alignability_picture.hpp"

#include "costmap/heading_layers.hpp"
#include "pictures/axes.hpp"
#include "pictures/heading_strip.hpp"
#include "pictures/legend.hpp"
#include "pictures/map_layers.hpp"
#include "pictures/map_layout.hpp"
#include "pictures/text.hpp"

namespace alignability {

void draw_alignability_map(const AlignabilityMap& map, const OccupancyMap& occupancy, const MapPictureOptions& options,
                           const std::filesystem::path& file) {
  using namespace detail;
  const std::vector<const Grid<float>*> headings = heading_layers(map);
  const MapLayout layout = lay_out(view_of(map.geometry, occupancy), options.title, headings.empty() ? 0 : 1);
  const double strip = headings.empty() ? 0.0 : strip_height(layout.view, headings.size());
  const Page page(layout.width, layout.bottom + strip + kMargin);
  const Context& context = page.context();

  draw_title(context, layout, options.title);
  draw_map(context, layout.view, map.alpha(), alignability_scale(Tone::full), occupancy, Tone::full);
  draw_axes(context, layout.view, kMapAxes);
  draw_scale_bar(context, layout.view);
  draw_map_legend(context, layout.legend, alignability_legend(options.risk, Tone::full));
  if (!headings.empty()) {
    const std::string caption = "At the worst of " + std::to_string(headings.size()) + " headings; below, facing as the arrows point";
    draw_text(context, caption, key_line(layout, options.title, 0), {.anchor = {0.0, 0.5}});
    draw_heading_strip(context, layout.view, headings, occupancy);
  }
  page.save(file);
}

}  // namespace alignability
