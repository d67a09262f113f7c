// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/error_map_picture.hpp"

#include <gmock/gmock.h>

#include <limits>
#include <stdexcept>

#include "pictures/colour_map.hpp"
#include "pictures/map_layout.hpp"
#include "tests/core/temporary_folder.hpp"
#include "tests/core/thrown_message.hpp"
#include "tests/costmap/ascii_map.hpp"
#include "tests/pictures/read_png.hpp"

namespace alignability {
namespace {

using namespace test;
using detail::error_colour;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

// Four cells of 2 m in a row, a wall of 1 m in the upper left corner.
class ErrorMapPicture : public ::testing::Test {
 protected:
  Picture drawn(std::vector<float> errors, std::span<const Pose2> route = {}, const ErrorMapOptions& options = {}) {
    const Grid<float> error({.resolution = 2.0, .width = 4, .height = 1}, std::move(errors));
    draw_error_map(error, occupancy_, route, options, folder_ / "error.png");
    view_ = detail::lay_out(detail::view_of(error.geometry(), occupancy_), options.title, 0).view;
    return Picture(folder_ / "error.png");
  }
  Eigen::Vector2d middle_of(int cell) const { return view_.to_pixel({2.0 * cell + 1.0, 0.5}); }

  TemporaryFolder folder_;
  OccupancyMap occupancy_ = ascii_map(1.0, {"#.......", "........"});
  detail::View view_;
};

TEST_F(ErrorMapPicture, ACellHasTheColourOfItsErrorAndGreyWhereNoneWasDriven) {
  const Picture picture = drawn({0.0f, 0.2f, 0.5f, kNaN}, {}, {.title = "errors", .limit = 0.5});
  EXPECT_LE(difference(picture.at(middle_of(0)), error_colour(0.0)), kRounding);
  EXPECT_LE(difference(picture.at(middle_of(1)), error_colour(0.4)), kRounding);
  EXPECT_LE(difference(picture.at(middle_of(2)), error_colour(1.0)), kRounding);
  EXPECT_LE(difference(picture.at(middle_of(3)), detail::kNotEvaluated), kRounding);
}

TEST_F(ErrorMapPicture, ErrorsBeyondTheLimitHaveItsColourHoweverLarge) {
  const Picture picture = drawn({0.31f, 1e30f, kInfinity, std::numeric_limits<float>::max()}, {}, {.title = "", .limit = 0.3});
  for (int cell = 0; cell < 4; ++cell) EXPECT_LE(difference(picture.at(middle_of(cell)), error_colour(1.0)), kRounding) << cell;
}

TEST_F(ErrorMapPicture, WallsAreDrawnOverTheErrors) {
  const Picture picture = drawn({0.1f, 0.1f, 0.1f, 0.1f});
  EXPECT_LE(difference(picture.at(view_.to_pixel({0.5, 1.5})), detail::wall_colour(detail::Tone::pale)), kRounding);
}

TEST_F(ErrorMapPicture, TheScaleOfColoursGoesFromZeroUpToTheLimitAndBeyond) {
  const Picture picture = drawn({kNaN, kNaN, kNaN, kNaN}, {}, {.title = "", .limit = 0.5});
  const double x = view_.frame.right() + 40.0;
  int last_light = 0;
  int first_dark = 0;
  int dark = 0;
  for (int y = 0; y < picture.height(); ++y) {
    const Colour colour = picture.at({x, y + 0.5});
    if (difference(colour, error_colour(0.0)) < 0.03) last_light = y;
    if (difference(colour, error_colour(1.0)) > 0.005) continue;
    if (dark++ == 0) first_dark = y;
  }
  EXPECT_GT(first_dark, 0);
  EXPECT_LT(first_dark + 100, last_light);
  EXPECT_GT(dark, 12) << "no arrowhead in the last colour";
}

TEST_F(ErrorMapPicture, TheRouteIsALineOverTheCellsAndBreaksWhereAPoseIsUnknown) {
  const std::vector<Pose2> route{{0.5, 0.5, 0.0}, {3.0, 0.5, 0.0}, {kNaN, 0.5, 0.0}, {5.0, 0.5, 0.0}, {7.5, 0.5, 0.0}};
  const Picture picture = drawn({0.0f, 0.0f, 0.0f, 0.0f}, route);
  const auto crossed = [&](double x) {
    double most = 0.0;
    for (double dy = -2.0; dy <= 2.0; ++dy) {
      most = std::max(most, difference(picture.at(view_.to_pixel({x, 0.5}) + Eigen::Vector2d(0.0, dy)), error_colour(0.0)));
    }
    return most > 0.3;
  };
  EXPECT_TRUE(crossed(1.5));
  EXPECT_TRUE(crossed(6.5));
  EXPECT_FALSE(crossed(4.0));
  EXPECT_LE(difference(picture.at(view_.to_pixel({1.5, 0.9})), error_colour(0.0)), kRounding);
}

TEST_F(ErrorMapPicture, ARouteFarBeyondTheMapIsCutOffAtItsFrame) {
  const std::vector<Pose2> away{{-1e9, 0.5, 0.0}, {1e9, 0.5, 0.0}};
  const Picture with = drawn({0.0f, 0.0f, 0.0f, 0.0f}, away);
  const double y = view_.to_pixel({0.0, 0.5}).y();
  EXPECT_LE(difference(with.at({view_.frame.right() + 8.0, y}), detail::kWhite), kRounding);
  EXPECT_EQ(drawn({0.0f, 0.0f, 0.0f, 0.0f}, std::vector<Pose2>{{1.0, 1.0, 0.0}}).width(), with.width());
}

TEST_F(ErrorMapPicture, ItsSizeIsBoundedWhateverTheMapsIs) {
  for (const auto& [width, height] : {std::pair{0, 0}, {1, 1}, {1, 3000}, {3000, 1}, {700, 700}}) {
    draw_error_map(Grid<float>({.width = width, .height = height}, 0.1f), OccupancyMap{}, {}, {}, folder_ / "error.png");
    const Picture picture(folder_ / "error.png");
    EXPECT_LT(std::max(picture.width(), picture.height()), 2200) << width << " x " << height;
    EXPECT_GT(std::min(picture.width(), picture.height()), 300) << width << " x " << height;
  }
}

TEST_F(ErrorMapPicture, ALimitThatIsNoPositiveNumberIsRefused) {
  for (const double limit : {0.0, -1.0, static_cast<double>(kNaN), static_cast<double>(kInfinity)}) {
    EXPECT_THROW(drawn({0.0f, 0.0f, 0.0f, 0.0f}, {}, {.title = "", .limit = limit}), std::invalid_argument);
  }
}

TEST_F(ErrorMapPicture, AFileThatCannotBeWrittenIsAnInputErrorThatNamesIt) {
  const auto png = folder_ / "absent/error.png";
  EXPECT_THAT(thrown_message([&] { draw_error_map({}, occupancy_, {}, {}, png); }),
              ::testing::StartsWith(png.string() + ": cannot be written"));
}

}  // namespace
}  // namespace alignability
