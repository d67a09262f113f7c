// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/scatter_picture.hpp"

#include <gmock/gmock.h>

#include <limits>

#include "pictures/colour_map.hpp"
#include "tests/core/temporary_folder.hpp"
#include "tests/core/thrown_message.hpp"
#include "tests/pictures/read_png.hpp"

namespace alignability {
namespace {

using namespace test;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr Colour kRed = colour_from_hex(0xff0000);
constexpr Colour kGreen = colour_from_hex(0x00ff00);
constexpr Colour kBlue = colour_from_hex(0x0000ff);

// Where a lone dot of that hue lies on a page of greys; NaN where there is none.
Eigen::Vector2d place_of(const Picture& picture, const Colour& hue) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  int found = 0;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      const Colour colour = picture.at(Eigen::Vector2d(x, y));
      const double spread = std::max({colour.red, colour.green, colour.blue}) - std::min({colour.red, colour.green, colour.blue});
      const Colour expected = detail::mixed(detail::kWhite, hue, spread);
      if (spread < 0.2 || difference(colour, expected) > 0.02) continue;
      sum += Eigen::Vector2d(x + 0.5, y + 0.5);
      ++found;
    }
  }
  return found == 0 ? Eigen::Vector2d(kNaN, kNaN) : Eigen::Vector2d(sum / found);
}

ScatterPanel panel_of(AxisScale scale, const Eigen::Vector2d& red, const Eigen::Vector2d& green, const Eigen::Vector2d& blue) {
  return {{"x", AxisScale::linear}, {"y", scale}, {{"", {red}, kRed}, {"", {green}, kGreen}, {"", {blue}, kBlue}}};
}

class ScatterPicture : public ::testing::Test {
 protected:
  Picture drawn(std::span<const ScatterPanel> panels) const {
    draw_scatter(panels, "title", folder_ / "scatter.png");
    return Picture(folder_ / "scatter.png");
  }
  Picture drawn(const ScatterPanel& panel) const { return drawn(std::span(&panel, 1)); }

  TemporaryFolder folder_;
};

TEST_F(ScatterPicture, ALinearAxisPutsEqualDifferencesApartAlike) {
  const Picture picture = drawn(panel_of(AxisScale::linear, {0.2, 1.0}, {0.4, 2.0}, {0.6, 3.0}));
  const Eigen::Vector2d first = place_of(picture, kRed);
  const Eigen::Vector2d step = place_of(picture, kGreen) - first;
  EXPECT_GT(step.x(), 100.0);
  EXPECT_LT(step.y(), -100.0);
  EXPECT_LT((place_of(picture, kBlue) - first - 2.0 * step).norm(), 1.0);
}

TEST_F(ScatterPicture, ALogarithmicAxisPutsEqualRatiosApartAlike) {
  const Picture picture = drawn(panel_of(AxisScale::logarithmic, {0.2, 0.01}, {0.4, 0.1}, {0.6, 1.0}));
  const Eigen::Vector2d first = place_of(picture, kRed);
  const Eigen::Vector2d step = place_of(picture, kGreen) - first;
  EXPECT_LT(step.y(), -100.0);
  EXPECT_LT((place_of(picture, kBlue) - first - 2.0 * step).norm(), 1.0);
}

TEST_F(ScatterPicture, WhatIsNotAboveZeroLiesAtTheLowerEndOfALogarithmicAxis) {
  const Picture picture = drawn(panel_of(AxisScale::logarithmic, {0.2, 0.0}, {0.4, -1e9}, {0.6, 0.01}));
  EXPECT_NEAR(place_of(picture, kRed).y(), place_of(picture, kGreen).y(), 0.7);
  EXPECT_NEAR(place_of(picture, kRed).y(), place_of(picture, kBlue).y(), 1.5) << "the least value ends the axis where it is round";
}

TEST_F(ScatterPicture, APointThatIsNotFiniteIsPassedOverAndMovesNoOther) {
  const auto place = [&](const Eigen::Vector2d& unknown) {
    const Picture picture = drawn(panel_of(AxisScale::linear, {0.2, 1.0}, {0.6, 3.0}, unknown));
    EXPECT_TRUE(place_of(picture, kBlue).hasNaN());
    return place_of(picture, kRed);
  };
  const Eigen::Vector2d expected = place({kNaN, kNaN});
  for (const Eigen::Vector2d& unknown :
       {Eigen::Vector2d(kNaN, 9.0), Eigen::Vector2d(9.0, kNaN), Eigen::Vector2d(9.0, kInfinity), Eigen::Vector2d(-kInfinity, 9.0)}) {
    EXPECT_EQ(place(unknown), expected);
  }
}

TEST_F(ScatterPicture, DotsAreTranslucentSoThatManyAreDarkerThanOne) {
  const ScatterPanel one{{"x"}, {"y"}, {{"", {{0.5, 0.5}, {1.0, 1.0}}, kBlue}}};
  ScatterPanel many = one;
  many.series[0].points.insert(many.series[0].points.end(), 50, {0.5, 0.5});
  const auto least_difference = [](const Picture& picture) {
    double least = 1.0;
    for (int y = 0; y < picture.height(); ++y) {
      for (int x = 0; x < picture.width(); ++x) least = std::min(least, difference(picture.at(Eigen::Vector2d(x, y)), kBlue));
    }
    return least;
  };
  EXPECT_GT(least_difference(drawn(one)), 0.3);
  EXPECT_LT(least_difference(drawn(many)), 0.05);
}

TEST_F(ScatterPicture, AThresholdIsALineAcrossItsPanelThatItsAxisReaches) {
  const ScatterPanel plain{{"x"}, {"y"}, {{"", {{0.2, 0.2}}, kBlue}}};
  ScatterPanel marked = plain;
  marked.x.thresholds = {{0.4, "safe"}, {kNaN, "none"}};
  marked.y.thresholds = {{1.0, "lost"}};
  EXPECT_GT(drawn(marked).count(detail::kFaintInk), drawn(plain).count(detail::kFaintInk) + 300);
  EXPECT_LT(place_of(drawn(marked), kBlue).x(), place_of(drawn(plain), kBlue).x() - 100.0);
}

TEST_F(ScatterPicture, PanelsStandSideBySide) {
  const ScatterPanel panel = panel_of(AxisScale::linear, {1.0, 1.0}, {0.4, 2.0}, {0.6, 3.0});
  ScatterPanel other = panel;
  for (ScatterSeries& series : other.series) series.points.clear();
  const Picture left = drawn(std::vector{panel, other});
  const Picture right = drawn(std::vector{other, panel});
  const Eigen::Vector2d apart = place_of(right, kGreen) - place_of(left, kGreen);
  EXPECT_GT(apart.x(), 600.0);
  EXPECT_NEAR(apart.y(), 0.0, 1e-9);
}

TEST_F(ScatterPicture, NothingAndHugeAndEqualValuesAreDrawn) {
  EXPECT_GT(drawn(std::vector<ScatterPanel>{}).width(), 500);
  for (const AxisScale scale : {AxisScale::linear, AxisScale::logarithmic}) {
    EXPECT_GT(drawn(ScatterPanel{{"x", scale}, {"y", scale}, {}}).width(), 500);
    EXPECT_FALSE(place_of(drawn(panel_of(scale, {0.5, 1e-300}, {1e12, 1e300}, {1.0, 1.0})), kGreen).hasNaN());
    EXPECT_FALSE(place_of(drawn(ScatterPanel{{"x", scale}, {"y", scale}, {{"", {{2.0, 2.0}}, kRed}}}), kRed).hasNaN());
    EXPECT_GT(drawn(panel_of(scale, {0.5, 5e-324}, {1.0, -1.7e308}, {2.0, 1.7e308})).width(), 500);
    EXPECT_FALSE(place_of(drawn(ScatterPanel{{"x"}, {"y", scale}, {{"", {{-3.0, -3.0}}, kRed}}}), kRed).hasNaN());
  }
}

TEST_F(ScatterPicture, AFileThatCannotBeWrittenIsAnInputErrorThatNamesIt) {
  const auto png = folder_ / "absent/scatter.png";
  EXPECT_THAT(thrown_message([&] { draw_scatter({}, "", png); }), ::testing::StartsWith(png.string() + ": cannot be written"));
}

}  // namespace
}  // namespace alignability
