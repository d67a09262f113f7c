// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "costmap/risk_field.hpp"
#include "pictures/colour_map.hpp"
#include "pictures/page.hpp"

namespace alignability::detail {

/// What the colours of a map mean: the scale of α with both thresholds of risk, below it the greys and the walls.
void draw_map_legend(const Context& context, const Rectangle& area, const RiskOptions& risk, Tone tone);

}  // namespace alignability::detail
