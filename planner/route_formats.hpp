// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "planner/json_file.hpp"
#include "planner/route_file.hpp"

namespace alignability::detail {

/// Coordinates that a route may have [m]: enough for a site in UTM.
inline constexpr Range kPlaces{.min = -1e7, .max = 1e7};

Route parse_path_table(std::string_view text, const std::filesystem::path& file);
Route parse_nav2_graph(const JsonValue& root);
Route parse_lif(const JsonValue& root, const RouteFileOptions& options);

}  // namespace alignability::detail
