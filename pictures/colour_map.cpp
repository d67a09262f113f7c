// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/colour_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace alignability::detail {
namespace {

// The eleven classes of ColorBrewer's RdYlBu.
constexpr std::array kRedYellowBlue = {
    colour_from_hex(0xa50026), colour_from_hex(0xd73027), colour_from_hex(0xf46d43), colour_from_hex(0xfdae61),
    colour_from_hex(0xfee090), colour_from_hex(0xffffbf), colour_from_hex(0xe0f3f8), colour_from_hex(0xabd9e9),
    colour_from_hex(0x74add1), colour_from_hex(0x4575b4), colour_from_hex(0x313695),
};

// Every tenth of matplotlib's magma but the darkest two, from light to dark: even steps of CIE lightness.
constexpr std::array kMagma = {
    colour_from_hex(0xfcfdbf), colour_from_hex(0xfecf92), colour_from_hex(0xfe9f6d), colour_from_hex(0xf7705c), colour_from_hex(0xde4968),
    colour_from_hex(0xb73779), colour_from_hex(0x8c2981), colour_from_hex(0x641a80), colour_from_hex(0x3b0f70),
};

// The eleven classes of ColorBrewer's RdBu, the middle one white.
constexpr std::array kRedWhiteBlue = {
    colour_from_hex(0x67001f), colour_from_hex(0xb2182b), colour_from_hex(0xd6604d), colour_from_hex(0xf4a582),
    colour_from_hex(0xfddbc7), colour_from_hex(0xffffff), colour_from_hex(0xd1e5f0), colour_from_hex(0x92c5de),
    colour_from_hex(0x4393c3), colour_from_hex(0x2166ac), colour_from_hex(0x053061),
};

// Neighbours in the list are far apart in hue, lightness or both.
constexpr std::array<Colour, kCategories> kCategoryColours = {
    colour_from_hex(0x1f77b4), colour_from_hex(0xe8710a), colour_from_hex(0x2a9d3c), colour_from_hex(0xc2185b),
    colour_from_hex(0x17becf), colour_from_hex(0x8c564b), colour_from_hex(0x7b3fb5), colour_from_hex(0xb5bd00),
    colour_from_hex(0xf06fb0), colour_from_hex(0x00695c), colour_from_hex(0xd4a017), colour_from_hex(0x1a237e),
};

// How far the pale tone is on the way to white.
constexpr double kPaleness = 0.52;

// Along the colours, 0 the first and 1 the last.
Colour interpolated(std::span<const Colour> colours, double share) {
  const double at = std::clamp(share, 0.0, 1.0) * static_cast<double>(colours.size() - 1);
  const std::size_t low = std::min(static_cast<std::size_t>(at), colours.size() - 2);
  return mixed(colours[low], colours[low + 1], at - static_cast<double>(low));
}

double linear(double part) { return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4); }

}  // namespace

Colour mixed(const Colour& from, const Colour& to, double share) {
  return {std::lerp(from.red, to.red, share), std::lerp(from.green, to.green, share), std::lerp(from.blue, to.blue, share)};
}

Colour alignability_colour(double alpha, Tone tone) {
  const Colour colour = interpolated(kRedYellowBlue, alpha);
  return tone == Tone::full ? colour : mixed(colour, kWhite, kPaleness);
}

ColourScale alignability_scale(Tone tone) {
  return [tone](double alpha) { return alignability_colour(alpha, tone); };
}

Colour error_colour(double share) { return interpolated(kMagma, share); }

Colour difference_colour(double share) { return interpolated(kRedWhiteBlue, 0.5 + 0.5 * share); }

Colour wall_colour(Tone tone) { return tone == Tone::full ? colour_from_hex(0x141414) : colour_from_hex(0x585858); }

Colour category_colour(std::size_t index) { return kCategoryColours[index % kCategories]; }

double luminance(const Colour& colour) {
  return 0.2126 * linear(colour.red) + 0.7152 * linear(colour.green) + 0.0722 * linear(colour.blue);
}

}  // namespace alignability::detail
