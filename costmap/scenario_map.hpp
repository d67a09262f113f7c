// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "costmap/alignability_map.hpp"

namespace alignability {

/// Several alignability maps of one site, as with its racks full and empty, in one: of a cell, the value below which α is in that share of
/// them, in [0, 1], the lower of two where it lies between; 0 is the worst case. A map that has no value there counts as less than any, so
/// that the cell may have none either. It has the layers `alpha` and those by heading alone, and no error model. Throws
/// std::invalid_argument without a map, and where their grids or headings differ.
AlignabilityMap scenario_map(std::span<const AlignabilityMap> maps, double quantile);

}  // namespace alignability
