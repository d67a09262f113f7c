// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "costmap/alignability_map.hpp"

namespace alignability {

struct MergedMap {
  AlignabilityMap map;
  std::size_t taken = 0;  ///< cells that have the values of the map that wins
  std::size_t lost = 0;   ///< cells in which it has values, off the grid of the other
};

/// Two maps of one site in one, on the grid of the second: cell by cell the first's values where it has α, else the second's. Where the
/// second alone is from a log the two change places, so that a log always wins over a simulation. A last layer, `logged`, is 1 where a
/// cell's values are from a log, 0 where they are simulated. What was said of how the second was made stays, but its error model, which was
/// fitted to other values. Throws std::invalid_argument that completes "the maps …" where their cells do not coincide or they have other
/// layers.
MergedMap merged(const AlignabilityMap& first, const AlignabilityMap& second);

}  // namespace alignability
