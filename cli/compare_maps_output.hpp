// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "cli/json.hpp"
#include "costmap/map_comparison.hpp"

namespace alignability::cli {

/// With the `worst` cells, the greatest fall first, and all that are lower.
Json comparison_json(const MapComparison& comparison, const MapComparisonOptions& options, std::size_t worst);

/// The same in words, without the cells that are lower.
void print_comparison(const MapComparison& comparison, const MapComparisonOptions& options, std::size_t worst, const std::string& first,
                      const std::string& second);

}  // namespace alignability::cli
