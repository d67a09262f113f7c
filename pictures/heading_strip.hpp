// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "costmap/occupancy_map.hpp"
#include "pictures/view.hpp"

namespace alignability::detail {

/// The height of a strip of that many small maps below a view's axis, and as wide as it [px].
double strip_height(const View& view, std::size_t maps);
/// Of one of them.
View small_view(const View& view, std::size_t number, std::size_t maps);

/// Small maps of α in rows, above each an arrow that way and its yaw: of n, the k-th 2πk/n.
void draw_heading_strip(const Context& context, const View& view, std::span<const Grid<float>* const> headings,
                        const OccupancyMap& occupancy);

}  // namespace alignability::detail
