// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/pose.hpp"
#include "costmap/alignability_map.hpp"
#include "costmap/occupancy_map.hpp"
#include "costmap/risk_field.hpp"
#include "pictures/colour.hpp"

namespace alignability {

/// α at the arc length s [m] from a path's start; NaN = unknown.
struct ProfilePoint {
  double s = 0.0;
  double alpha = 0.0;
};

enum class LineStyle { solid, dashed };

/// A black and a green that differ in luminance as well, so that together with the dashes no one mixes them up.
inline constexpr Colour kShortestColour = colour_from_hex(0x1c1c1c);
inline constexpr Colour kRiskAwareColour = colour_from_hex(0x00875a);

/// To tell routes apart by, from those two on; none is the red of blind stretches. They repeat after kRouteColours.
Colour route_colour(std::size_t number);
inline constexpr std::size_t kRouteColours = 8;

struct DrawnPath {
  std::string label;         ///< as in the key: "shortest: 52.3 m, 31.0 m blind"; empty: in neither the key nor the panel of profiles
  std::vector<Pose2> poses;  ///< in `map`, joined by straight segments; empty: in the key alone
  /// s ascending from 0 to the path's length, which stretches over the whole of `poses`; without it the path is drawn without its
  /// blind stretches.
  std::vector<ProfilePoint> profile;
  Colour colour = kRiskAwareColour;
  LineStyle style = LineStyle::solid;  ///< a dashed path is drawn over the solid ones, which show through the gaps
};

struct PathPictureOptions {
  std::string title;           ///< none when empty
  RiskOptions risk;            ///< what counts as blind
  std::optional<Pose2> start;  ///< marked with its heading
  std::optional<Pose2> goal;
  double robot_radius = 0.0;                 ///< drawn to scale about start and goal where it exceeds their markers [m]
  std::vector<Eigen::Vector2d> footprint{};  ///< in the disk's place where it has corners, in `base_link` [m]
  std::optional<Grid<float>> risk_map{};     ///< in α's place on the map where it is given: a risk that has other sources too, >= 0
};

/// Draws paths over a pale alignability map, or one of the risk, blue where there is none and red where it is greatest; blind stretches in
/// a red halo, and below it α along each path. Blind is α below `risk.alpha_critical`, and unknown α under `UnknownPolicy::risky`. What
/// lies beyond the maps is cut off. Throws InputError when the file is not named .png, .svg or .pdf, or cannot be written.
void draw_paths(const AlignabilityMap& map, const OccupancyMap& occupancy, std::span<const DrawnPath> paths,
                const PathPictureOptions& options, const std::filesystem::path& file);

}  // namespace alignability
