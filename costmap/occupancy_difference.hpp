// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "costmap/occupancy_map.hpp"

namespace alignability {

/// How two maps of the same cells stand to each other in one of them.
enum class CellAgreement : std::uint8_t {
  not_compared,  ///< one of the two knows nothing
  both_free,
  both_occupied,
  within_a_cell,       ///< they differ, but each says in a cell next to it, corners included, what the other says here
  occupied_in_first,   ///< free in the second
  occupied_in_second,  ///< free in the first
};

struct OccupancyDifference {
  Grid<CellAgreement> cells;
  std::size_t compared = 0;   ///< cells that both maps know
  std::size_t differing = 0;  ///< of these, the ones that are occupied in one map alone, and not within a cell

  /// The share of the compared cells that do not differ; NaN when none is compared.
  double agreement() const { return 1.0 - static_cast<double>(differing) / static_cast<double>(compared); }
};

/// Compares cell by cell. Throws std::invalid_argument unless both maps have the same geometry. O(cells).
OccupancyDifference occupancy_difference(const OccupancyMap& first, const OccupancyMap& second);

}  // namespace alignability
