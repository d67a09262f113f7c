// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>

#include "pictures/colour.hpp"

namespace alignability::detail {

enum class Tone {
  full,
  pale,  ///< for a ground that something is drawn on
};

/// What colour a value is drawn in; never asked about NaN.
using ColourScale = std::function<Colour(double)>;

/// α in [0,1] from red over pale yellow to blue, values beyond as the nearer end. Luminance falls from the middle to both ends, and red
/// against blue is told apart in every common colour blindness.
Colour alignability_colour(double alpha, Tone tone);
ColourScale alignability_scale(Tone tone);

/// The share in [0,1] of an error in the largest that is shown, from pale yellow over red to dark violet, shares beyond as the nearer end.
/// Lightness falls evenly.
Colour error_colour(double share);

/// The share in [-1,1] of a difference in the largest that is shown, from red over white at 0 to blue, shares beyond as the nearer end.
Colour difference_colour(double share);

/// Near black, and a dark grey that a black path shows on.
Colour wall_colour(Tone tone);

/// Colours to tell things apart by, none of them grey; they repeat after `kCategories`.
Colour category_colour(std::size_t index);
inline constexpr std::size_t kCategories = 12;

/// `share` of the way from one colour to the other.
Colour mixed(const Colour& from, const Colour& to, double share);

/// Relative luminance as WCAG 2 defines it, in [0,1].
double luminance(const Colour& colour);

inline constexpr Colour kWhite = colour_from_hex(0xffffff);
inline constexpr Colour kInk = colour_from_hex(0x1c1c1c);
inline constexpr Colour kFaintInk = colour_from_hex(0x6a6a6a);
inline constexpr Colour kNotEvaluated = colour_from_hex(0xd2d2d2);
inline constexpr Colour kUnknown = colour_from_hex(0xefefef);
inline constexpr Colour kHatch = colour_from_hex(0x9a9a9a);
inline constexpr Colour kBlind = colour_from_hex(0xe2001a);

}  // namespace alignability::detail
