// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <limits>
#include <string>

#include "pictures/colour_map.hpp"
#include "pictures/page.hpp"

namespace alignability::detail {

inline constexpr double kTitleSize = 24.0;
inline constexpr double kLabelSize = 18.0;
inline constexpr double kTickSize = 16.0;
inline constexpr double kNoteSize = 15.0;

enum class Weight { normal, bold };

struct TextStyle {
  double size = kLabelSize;  ///< [px]
  Colour colour = kInk;
  Weight weight = Weight::normal;
  /// The point of the text that is put in its place: 0 its left end, 1 its right end; 0 the top of capitals, 1 the baseline.
  Eigen::Vector2d anchor{0.0, 1.0};
  double widest = std::numeric_limits<double>::infinity();  ///< what would be wider is set smaller [px]
};

void draw_text(const Context& context, const std::string& text, const Eigen::Vector2d& at, const TextStyle& style);
/// Small and faint: what a line or a strip at `at` is.
void draw_note(const Context& context, const std::string& text, const Eigen::Vector2d& at, const Eigen::Vector2d& anchor);
/// With a rim of white, to be read on any ground.
void draw_rimmed_text(const Context& context, const std::string& text, const Eigen::Vector2d& at, const TextStyle& style);
/// Reading upwards; the anchor is still the text's own.
void draw_upward_text(const Context& context, const std::string& text, const Eigen::Vector2d& at, const TextStyle& style);

/// [px]; depends on the fonts installed.
double text_width(const std::string& text, double size, Weight weight);
double capital_height(double size);

}  // namespace alignability::detail
