// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/yaml_map.hpp"
#include "planner/plan_problem.hpp"

namespace alignability::detail {

/// What the key `sources` of a problem's `risk` says.
struct RiskSources {
  double alpha_weight = 1.0;
  std::vector<RiskSource> sources;          ///< without their values
  std::vector<TextPosition> raster_places;  ///< of each in the file, for what is wrong with its raster
};

RiskSources read_risk_sources(YamlMap yaml);

/// The sources of a problem file with their values, from the occupancy map and the rasters that they name. Throws InputError.
std::vector<RiskSource> with_values(const ProblemFile& file, const OccupancyMap& occupancy);

/// ", sources: {…}" as the file has it; empty without any.
std::string sources_text(const RiskOptions& risk);

}  // namespace alignability::detail
