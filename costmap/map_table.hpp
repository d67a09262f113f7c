// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "costmap/alignability_map.hpp"

namespace alignability {

/// x,y and a column a layer, a line for each cell that has a value in any: the cell's centre in `map` [m]; six digits behind the point,
/// empty where there is no value.
std::string to_csv(const AlignabilityMap& map);

/// What puts a TIFF of that grid, its top row first, in its place for programs that read no YAML: an ESRI world file, six lines [m].
std::string world_file(const GridGeometry& geometry);

}  // namespace alignability
