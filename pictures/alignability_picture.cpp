// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/alignability_picture.hpp"

#include "pictures/axes.hpp"
#include "pictures/legend.hpp"
#include "pictures/map_layers.hpp"
#include "pictures/map_layout.hpp"

namespace alignability {

void draw_alignability_map(const AlignabilityMap& map, const OccupancyMap& occupancy, const MapPictureOptions& options,
                           const std::filesystem::path& png) {
  using namespace detail;
  const MapLayout layout = lay_out(view_of(map.geometry, occupancy), options.title, 0);
  const Page page(layout.width, layout.bottom + kMargin);
  const Context& context = page.context();

  draw_title(context, layout, options.title);
  draw_map(context, layout.view, map.alpha(), alignability_scale(Tone::full), occupancy, Tone::full);
  draw_axes(context, layout.view, kMapAxes);
  draw_scale_bar(context, layout.view);
  draw_map_legend(context, layout.legend, alignability_legend(options.risk, Tone::full));
  page.save(png);
}

}  // namespace alignability
