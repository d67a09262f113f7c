// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "pictures/page.hpp"
#include "pictures/path_picture.hpp"

namespace alignability::detail {

/// α along each path over its arc length, and under the curves a strip a path, red where it is blind. `area` is that of curves and strips;
/// the axis takes up `kBelowFrame` more below, and names of lines the legend's room to the right.
/// `longest` is where the axis of arc length ends [m], 1 m where it is 0.
void draw_profiles(const Context& context, const Rectangle& area, std::span<const DrawnPath> paths, double longest,
                   const RiskOptions& risk);

/// The arc length at which the last of the profiles ends [m]; 0 without any.
double longest_profile(std::span<const DrawnPath> paths);

/// The height of the area that a panel needs for its paths [px].
double profile_height(std::size_t paths);

}  // namespace alignability::detail
