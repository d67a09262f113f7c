// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "pictures/chart_axis.hpp"
#include "pictures/path_picture.hpp"

namespace alignability {

/// Localization errors at the arc length s from a path's start, over many drives along it [m]; NaN = unknown, which leaves a gap.
struct ErrorPoint {
  double s = 0.0;
  double mean = 0.0;
  double p95 = 0.0;  ///< the 95th percentile
};

/// What the drives along one path came to.
struct ErrorProfile {
  std::string label;                ///< as in the key: "shortest: 50.4 m, 38 of 50 lost"
  std::vector<ErrorPoint> errors;   ///< s ascending
  std::vector<ProfilePoint> alpha;  ///< s ascending from 0; without it the path is not in the panel of α
  Colour colour = kRiskAwareColour;
  LineStyle style = LineStyle::solid;  ///< of the mean and of α
};

struct ErrorProfileOptions {
  std::string title;                                    ///< none when empty
  ChartAxis axis = {.name = "localization error [m]"};  ///< of the errors; its thresholds are what they are held against
  RiskOptions risk;                                     ///< what counts as blind
};

/// Draws the mean error along each path and a band from it up to the 95th percentile, and below it α along each path on the same axis of
/// arc length, unless no profile has α. Throws InputError when the file is not named .png, .svg or .pdf, or cannot be written.
void draw_error_profiles(std::span<const ErrorProfile> profiles, const ErrorProfileOptions& options, const std::filesystem::path& file);

}  // namespace alignability
