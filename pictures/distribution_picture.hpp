// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "pictures/path_picture.hpp"

namespace alignability {

/// Values of one kind, drawn as the share of them that is at most so much.
struct DistributionCurve {
  std::string label;           ///< none when empty
  std::vector<double> values;  ///< finite, in any order
  Colour colour = kRiskAwareColour;
  LineStyle style = LineStyle::solid;
};

struct DistributionPanel {
  std::string name;  ///< of the axis, with its unit
  std::vector<DistributionCurve> curves;
  double from = 0.0;  ///< where its axis starts, unless a value lies below
};

/// Draws cumulative distributions, a panel beside the other. Throws InputError when the file is not named .png, .svg or .pdf, or cannot be
/// written.
void draw_distributions(std::span<const DistributionPanel> panels, const std::string& title, const std::filesystem::path& file);

}  // namespace alignability
