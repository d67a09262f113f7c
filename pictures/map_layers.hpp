// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pictures/colour_map.hpp"
#include "pictures/page.hpp"
#include "pictures/view.hpp"

namespace alignability::detail {

/// Both maps, one on the other, each over the whole of its extent. Where a pixel holds several cells, its α is the mean of those that
/// have a value; it is wall if one of them is, so that no wall is lost on a large map, and unknown if all of them are.
/// O(cells + pixels).
void draw_map(const Context& context, const View& view, const AlignabilityMap& map, const OccupancyMap& occupancy, Tone tone);

/// The walls and the unknown alone, as `draw_map` has them; the free stays as it is.
void draw_occupancy(const Context& context, const View& view, const OccupancyMap& occupancy, Tone tone);

/// A patch the way unknown cells are drawn.
void paint_hatch(const Context& context, const Rectangle& area);

}  // namespace alignability::detail
