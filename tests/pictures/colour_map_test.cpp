// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/colour_map.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "pictures/path_picture.hpp"
#include "tests/pictures/read_png.hpp"

namespace alignability::detail {
namespace {

constexpr int kSteps = 500;

double alpha_of(int step) { return static_cast<double>(step) / kSteps; }

TEST(ColourMap, LuminanceFallsFromTheMiddleToBothEnds) {
  for (const Tone tone : {Tone::full, Tone::pale}) {
    for (int i = 0; i < kSteps; ++i) {
      const double here = luminance(alignability_colour(alpha_of(i), tone));
      const double next = luminance(alignability_colour(alpha_of(i + 1), tone));
      const bool rises = alpha_of(i) < 0.5;
      EXPECT_EQ(here < next, rises) << "at " << alpha_of(i);
      EXPECT_NE(here, next) << "at " << alpha_of(i);
    }
  }
}

TEST(ColourMap, RedRulesTheLowerHalfAndBlueTheUpper) {
  for (double alpha = 0.0; alpha <= 0.48; alpha += 0.002) {
    const Colour colour = alignability_colour(alpha, Tone::full);
    EXPECT_GT(colour.red, colour.blue) << "at " << alpha;
  }
  for (double alpha = 0.6; alpha <= 1.0; alpha += 0.002) {
    const Colour colour = alignability_colour(alpha, Tone::full);
    EXPECT_GT(colour.blue, colour.red) << "at " << alpha;
  }
}

TEST(ColourMap, HasNoJumps) {
  for (int i = 0; i < kSteps; ++i) {
    EXPECT_LT(test::difference(alignability_colour(alpha_of(i), Tone::full), alignability_colour(alpha_of(i + 1), Tone::full)), 0.02);
  }
}

TEST(ColourMap, BeyondItsEndsIsTheNearerEnd) {
  EXPECT_EQ(alignability_colour(-1.0, Tone::full), alignability_colour(0.0, Tone::full));
  EXPECT_EQ(alignability_colour(2.0, Tone::full), alignability_colour(1.0, Tone::full));
}

TEST(ColourMap, PathsContrastWithEveryPaleColour) {
  for (const Colour& path : {kShortestColour, kRiskAwareColour}) {
    for (int i = 0; i <= kSteps; ++i) {
      const double ground = luminance(alignability_colour(alpha_of(i), Tone::pale));
      // What WCAG 2 asks of graphics is 3 : 1; the casing makes up for the rest at the ends.
      EXPECT_GT((ground + 0.05) / (luminance(path) + 0.05), 1.4) << "at " << alpha_of(i);
    }
  }
}

// CIE L*, of 100.
double lightness(const Colour& colour) { return 116.0 * std::cbrt(luminance(colour)) - 16.0; }

TEST(ColourMap, TheLightnessOfErrorsFallsEvenly) {
  const double whole = lightness(error_colour(0.0)) - lightness(error_colour(1.0));
  EXPECT_GT(whole, 70.0);
  for (int i = 0; i < 8; ++i) {
    const double step = lightness(error_colour(i / 8.0)) - lightness(error_colour((i + 1) / 8.0));
    EXPECT_NEAR(step, whole / 8.0, 0.2 * whole / 8.0) << "at " << i / 8.0;
  }
}

TEST(ColourMap, ErrorsBeyondTheEndsHaveTheNearerEnd) {
  EXPECT_EQ(error_colour(-1.0), error_colour(0.0));
  EXPECT_EQ(error_colour(std::numeric_limits<double>::infinity()), error_colour(1.0));
}

TEST(ColourMap, CategoriesAreDistinct) {
  for (std::size_t i = 0; i < kCategories; ++i) {
    for (std::size_t j = 0; j < i; ++j) EXPECT_GT(test::difference(category_colour(i), category_colour(j)), 0.1) << i << " and " << j;
  }
  EXPECT_EQ(category_colour(kCategories), category_colour(0));
}

}  // namespace
}  // namespace alignability::detail
