// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/pose.hpp"

namespace alignability {

/// A path in the shape of nav_msgs/Path, as YAML, in the frame `map`, its stamps 0.
std::string to_nav_path(std::span<const Pose2> path);

/// A GeoJSON Feature, a LineString in the coordinates of `map` [m], which are not the degrees that GeoJSON would have: what shows it must
/// be told so. Its headings [rad] are among the properties.
std::string to_geojson(std::span<const Pose2> path, std::string_view name);

}  // namespace alignability
