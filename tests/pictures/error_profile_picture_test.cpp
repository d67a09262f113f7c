// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/error_profile_picture.hpp"

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
constexpr double kFrameTop = 28.0 + 2 * 30.0 + 12.0;  // without a title, with one profile [px]

ErrorProfile even(double length, double mean, double p95) {
  return {"path", {{0.0, mean, p95}, {0.5 * length, mean, p95}, {length, mean, p95}}, {}, kRiskAwareColour, LineStyle::solid};
}

// How many pixels below the key are nearly that colour in a row of the page, or in a column.
int count_in_row(const Picture& picture, int y, const Colour& colour) {
  int found = 0;
  for (int x = 0; x < picture.width(); ++x) found += difference(picture.at(Eigen::Vector2d(x, y)), colour) < 0.02 ? 1 : 0;
  return found;
}
int count_in_column(const Picture& picture, int x, const Colour& colour) {
  int found = 0;
  for (int y = static_cast<int>(kFrameTop); y < picture.height(); ++y) {
    found += difference(picture.at(Eigen::Vector2d(x, y)), colour) < 0.02 ? 1 : 0;
  }
  return found;
}

// The row in which a line of that colour is longest, the lowest of several: the mean, not the rim of its band.
int row_of(const Picture& picture, const Colour& colour) {
  int best = 0;
  for (int y = static_cast<int>(kFrameTop); y < picture.height(); ++y) {
    if (count_in_row(picture, y, colour) >= count_in_row(picture, best, colour)) best = y;
  }
  return best;
}

class ErrorProfilePicture : public ::testing::Test {
 protected:
  Picture drawn(std::span<const ErrorProfile> profiles, const ErrorProfileOptions& options = {}) const {
    draw_error_profiles(profiles, options, folder_ / "profiles.png");
    return Picture(folder_ / "profiles.png");
  }
  Picture drawn(const ErrorProfile& profile, const ErrorProfileOptions& options = {}) const {
    return drawn(std::span(&profile, 1), options);
  }

  TemporaryFolder folder_;
  Colour band_ = detail::mixed(detail::kWhite, kRiskAwareColour, 0.22);
};

TEST_F(ErrorProfilePicture, TheMeanIsALineAndTheBandReachesUpToThePercentile) {
  const Picture picture = drawn(even(10.0, 0.2, 0.8));
  const int middle = picture.width() / 2;
  const int mean = row_of(picture, kRiskAwareColour);
  const int band = count_in_column(picture, middle, band_);
  // The axis ends a little over 0.8, so that 0.6 is somewhat less than three quarters of the frame's 380 px.
  EXPECT_NEAR(band, 0.6 / (0.8 * 1.06) * 380.0, 4.0);
  EXPECT_GT(count_in_row(picture, mean, kRiskAwareColour), 900);
  EXPECT_EQ(count_in_row(picture, mean + 6, band_), 0);
  EXPECT_GT(count_in_row(picture, mean - 6, band_), 900);
}

TEST_F(ErrorProfilePicture, TwoPathsShareTheAxisOfTheLonger) {
  std::vector<ErrorProfile> profiles{even(20.0, 0.2, kNaN), even(10.0, 0.8, kNaN)};
  profiles[1].colour = colour_from_hex(0xff0000);
  const Picture picture = drawn(profiles);
  const int row = row_of(picture, profiles[1].colour);
  EXPECT_NEAR(count_in_row(picture, row, profiles[1].colour), 500, 4);
  EXPECT_GT(count_in_row(picture, row_of(picture, kRiskAwareColour), kRiskAwareColour), 990);
}

TEST_F(ErrorProfilePicture, AlphaSharesTheAxisEvenWhereItEndsElsewhere) {
  ErrorProfile profile = even(20.0, 0.2, kNaN);
  profile.colour = colour_from_hex(0xff00ff);
  profile.alpha = {{0.0, 0.9}, {10.0, 0.9}};
  const Picture picture = drawn(profile);
  const int below = static_cast<int>(kFrameTop) + 400;
  int longest = 0;
  for (int y = below; y < picture.height(); ++y) longest = std::max(longest, count_in_row(picture, y, profile.colour));
  EXPECT_NEAR(longest, 500, 4);
}

TEST_F(ErrorProfilePicture, BlindStretchesAreMarkedBelow) {
  ErrorProfile profile = even(10.0, 0.2, 0.3);
  const int without = drawn(profile).height();
  profile.alpha = {{0.0, 0.0}, {5.0, 0.0}, {5.01, 0.9}, {10.0, 0.9}};
  const Picture picture = drawn(profile);
  EXPECT_GT(picture.height(), without + 200);
  // A strip of 12 rows, of which the path's own line touches four.
  EXPECT_NEAR(picture.count(detail::kBlind), 500 * 8, 50);
}

TEST_F(ErrorProfilePicture, AnUnknownErrorLeavesAGapInLineAndBand) {
  ErrorProfile profile{"path", {}, {}, kRiskAwareColour, LineStyle::solid};
  for (int i = 0; i <= 10; ++i) profile.errors.push_back({static_cast<double>(i), i == 5 ? kNaN : 0.2, 0.8});
  const Picture picture = drawn(profile);
  const int row = row_of(picture, kRiskAwareColour);
  EXPECT_NEAR(count_in_row(picture, row, kRiskAwareColour), 800, 4);
  EXPECT_NEAR(count_in_row(picture, row - 20, band_), 800, 4);
}

TEST_F(ErrorProfilePicture, AThresholdIsDrawnWhereTheErrorsDoNotReachItToo) {
  ErrorProfileOptions options;
  options.axis.thresholds = {{0.5, "lost"}};
  const Picture picture = drawn(even(10.0, 0.01, 0.02), options);
  const int line = row_of(picture, detail::kFaintInk);
  EXPECT_GT(count_in_row(picture, line, detail::kFaintInk), 400);
  EXPECT_LT(line + 200, row_of(picture, kRiskAwareColour));
}

TEST_F(ErrorProfilePicture, OnALogarithmicAxisAnErrorOfZeroLiesAtItsLowerEnd) {
  ErrorProfileOptions options;
  options.axis.scale = AxisScale::logarithmic;
  options.axis.thresholds = {{1.0, "lost"}};
  const Picture picture = drawn(even(10.0, 0.0, 0.1), options);
  EXPECT_NEAR(row_of(picture, kRiskAwareColour), kFrameTop + 380.0, 3.0);
}

TEST_F(ErrorProfilePicture, NothingAndUnknownAndHugeErrorsAreDrawn) {
  EXPECT_GT(drawn(std::vector<ErrorProfile>{}).width(), 500);
  for (const AxisScale scale : {AxisScale::linear, AxisScale::logarithmic}) {
    ErrorProfileOptions options;
    options.axis.scale = scale;
    EXPECT_GT(drawn(even(0.0, 0.0, 0.0), options).width(), 500);
    EXPECT_GT(drawn(even(10.0, kNaN, kNaN), options).width(), 500);
    EXPECT_GT(drawn(even(10.0, 0.1, kInfinity), options).width(), 500);
    EXPECT_GT(drawn(even(1e9, 1e-12, 1e12), options).count(kRiskAwareColour), 900);
  }
  EXPECT_GT(drawn(ErrorProfile{"", {}, {{0.0, kNaN}}, kRiskAwareColour, LineStyle::dashed}).width(), 500);
}

TEST_F(ErrorProfilePicture, AFileThatCannotBeWrittenIsAnInputErrorThatNamesIt) {
  const auto png = folder_ / "absent/profiles.png";
  EXPECT_THAT(thrown_message([&] { draw_error_profiles({}, {}, png); }), ::testing::StartsWith(png.string() + ": cannot be written"));
}

}  // namespace
}  // namespace alignability
