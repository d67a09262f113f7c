// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pictures/colour_map.hpp"
#include "pictures/page.hpp"
#include "pictures/view.hpp"

namespace alignability::detail {

/// A map's values and the walls on them, each over the whole of its extent. Where a pixel holds several cells, its value is the mean of
/// those that are not NaN, and grey where there is none; it is wall if one of them is, so that no wall is lost on a large map, and unknown
/// if all of them are. O(cells + pixels).
void draw_map(const Context& context, const View& view, const Grid<float>& values, const ColourScale& colour_of,
              const OccupancyMap& occupancy, Tone tone);

/// The walls and the unknown alone, as `draw_map` has them; the free stays as it is.
void draw_occupancy(const Context& context, const View& view, const OccupancyMap& occupancy, Tone tone);

/// A patch the way unknown cells are drawn.
void paint_hatch(const Context& context, const Rectangle& area);

}  // namespace alignability::detail
