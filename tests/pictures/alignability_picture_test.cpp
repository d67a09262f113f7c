// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/alignability_picture.hpp"

#include <gmock/gmock.h>

#include "core/file.hpp"
#include "pictures/colour_map.hpp"
#include "pictures/heading_strip.hpp"
#include "pictures/map_layout.hpp"
#include "tests/core/temporary_folder.hpp"
#include "tests/core/thrown_message.hpp"
#include "tests/costmap/heading_maps.hpp"
#include "tests/pictures/read_png.hpp"
#include "tests/pictures/small_site.hpp"

namespace alignability {
namespace {

using namespace test;
using detail::alignability_colour;
using detail::Tone;

constexpr int kWidest = 2200;

class AlignabilityPicture : public ::testing::Test {
 protected:
  Picture drawn(const AlignabilityMap& map, const OccupancyMap& occupancy, const MapPictureOptions& options = {}) {
    draw_alignability_map(map, occupancy, options, folder_ / "map.png");
    view_ = detail::lay_out(detail::view_of(map.geometry, occupancy), options.title, 0).view;
    return Picture(folder_ / "map.png");
  }
  Colour colour_at(const Picture& picture, const Eigen::Vector2d& point) const { return picture.at(view_.to_pixel(point)); }

  TemporaryFolder folder_;
  detail::View view_;
};

TEST_F(AlignabilityPicture, ACellHasTheColourOfItsAlpha) {
  const SmallSite site;
  const Picture picture = drawn(site.map, site.occupancy);
  EXPECT_LE(difference(colour_at(picture, site.poor), alignability_colour(0.02, Tone::full)), kRounding);
  EXPECT_LE(difference(colour_at(picture, site.rich), alignability_colour(0.95, Tone::full)), kRounding);
  EXPECT_LE(difference(colour_at(picture, site.middling), alignability_colour(0.5, Tone::full)), kRounding);
  EXPECT_LE(difference(colour_at(picture, site.none), detail::kNotEvaluated), kRounding);
}

TEST_F(AlignabilityPicture, PoorIsRedAndRichIsBlue) {
  const SmallSite site;
  const Picture picture = drawn(site.map, site.occupancy);
  const Colour poor = colour_at(picture, site.poor);
  const Colour rich = colour_at(picture, site.rich);
  EXPECT_GT(poor.red, 2.0 * std::max(poor.green, poor.blue));
  EXPECT_GT(rich.blue, 1.5 * std::max(rich.red, rich.green));
}

TEST_F(AlignabilityPicture, TheTopOfTheMapIsAtTheTopAndTheLeftAtTheLeft) {
  const SmallSite site;
  const Picture picture = drawn(site.map, site.occupancy);
  const detail::Rectangle& frame = view_.frame;
  const Eigen::Vector2d wall = view_.to_pixel(site.wall);
  EXPECT_LT(wall.x(), frame.left + 0.5 * frame.width);
  EXPECT_LT(wall.y(), frame.top + 0.5 * frame.height);
  EXPECT_LE(difference(picture.at(wall), detail::wall_colour(Tone::full)), kRounding);
}

TEST_F(AlignabilityPicture, AWallIsDrawnAtTheResolutionOfTheOccupancy) {
  const SmallSite site;
  const Picture picture = drawn(site.map, site.occupancy);
  EXPECT_LT(detail::luminance(colour_at(picture, {-0.95, 0.05})), 0.05);
  EXPECT_GT(detail::luminance(colour_at(picture, {0.05, 0.5})), 0.3);
  EXPECT_GT(detail::luminance(colour_at(picture, {-0.5, -0.05})), 0.3);
}

TEST_F(AlignabilityPicture, TheUnknownIsHatched) {
  const SmallSite site;
  const Picture picture = drawn(site.map, site.occupancy);
  double darkest = 1.0;
  double lightest = 0.0;
  for (double x = 2.1; x < 2.9; x += 0.01) {
    const Colour colour = colour_at(picture, {x, 0.5});
    EXPECT_NEAR(colour.red, colour.blue, kRounding) << "not grey";
    darkest = std::min(darkest, colour.red);
    lightest = std::max(lightest, colour.red);
  }
  EXPECT_GT(lightest - darkest, 0.2);
}

TEST_F(AlignabilityPicture, NoWallIsLostWhereAPixelHoldsManyCells) {
  const GridGeometry geometry{.resolution = 0.1, .width = 6000, .height = 200};
  Grid<float> occupancy(geometry, 0.0f);
  for (int x = 0; x < geometry.width; ++x) occupancy[Cell{x, 101}] = 1.0f;
  const AlignabilityMap map = uniform_alpha_map({.resolution = 1.0, .width = 600, .height = 20}, 0.5f);
  const Picture picture = drawn(map, OccupancyMap(occupancy));
  const Eigen::Vector2d wall = view_.to_pixel({0.0, 10.15});
  for (double x = view_.frame.left + 1.0; x < view_.frame.right() - 1.0; ++x) {
    ASSERT_LE(difference(picture.at({x, wall.y()}), detail::wall_colour(Tone::full)), kRounding) << "column " << x;
  }
}

TEST_F(AlignabilityPicture, ItsSizeIsBoundedWhateverTheMapsIs) {
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 3000}, {3000, 1}, {37, 1401}, {2000, 2000}, {700, 700}}) {
    SCOPED_TRACE(std::to_string(width) + " x " + std::to_string(height));
    const Picture picture = drawn(uniform_alpha_map({.width = width, .height = height}, 0.5f), OccupancyMap{});
    EXPECT_LT(picture.width(), kWidest);
    EXPECT_LT(picture.height(), kWidest);
    EXPECT_GT(picture.width(), 500);
    EXPECT_GT(picture.height(), 300);
  }
}

TEST_F(AlignabilityPicture, AMapWithoutASingleValueIsAllGrey) {
  const AlignabilityMap map = uniform_alpha_map({.width = 5, .height = 4}, std::numeric_limits<float>::quiet_NaN());
  const Picture picture = drawn(map, OccupancyMap{});
  for (const std::size_t i : {0u, 7u, 19u}) {
    EXPECT_LE(difference(colour_at(picture, map.geometry.center(map.geometry.cell_of(i))), detail::kNotEvaluated), kRounding);
  }
}

TEST_F(AlignabilityPicture, AMapWithoutCellsIsDrawn) { EXPECT_GT(drawn(uniform_alpha_map({}, 0.0f), OccupancyMap{}).width(), 0); }

TEST_F(AlignabilityPicture, ATitleMovesTheMapDown) {
  const SmallSite site;
  const int without = drawn(site.map, site.occupancy).height();
  const Picture titled = drawn(site.map, site.occupancy, {.title = "a site", .risk = {}});
  EXPECT_GT(titled.height(), without);
  EXPECT_LE(difference(colour_at(titled, site.wall), detail::wall_colour(Tone::full)), kRounding);
}

TEST_F(AlignabilityPicture, AFileThatCannotBeWrittenIsAnInputErrorThatNamesIt) {
  const SmallSite site;
  const auto png = folder_ / "absent/map.png";
  EXPECT_THAT(thrown_message([&] { draw_alignability_map(site.map, site.occupancy, {}, png); }),
              ::testing::StartsWith(png.string() + ": cannot be written"));
}

TEST_F(AlignabilityPicture, TheSameMapGivesTheSameBytes) {
  const SmallSite site;
  for (const char* name : {"a.png", "b.png"}) draw_alignability_map(site.map, site.occupancy, {}, folder_ / name);
  EXPECT_EQ(read_file(folder_ / "a.png", 1u << 24), read_file(folder_ / "b.png", 1u << 24));
}

TEST_F(AlignabilityPicture, ShowsEachHeadingBelow) {
  const OccupancyMap occupancy = ascii_map(1.0, {"....", "...."});
  const AlignabilityMap map = heading_map({.resolution = 1.0, .width = 4, .height = 2}, 4,
                                          [](const Eigen::Vector2d&, double yaw) { return static_cast<float>(0.2 * yaw); });
  draw_alignability_map(map, occupancy, {.title = "headings", .risk = {}}, folder_ / "map.png");
  const Picture picture(folder_ / "map.png");
  const detail::View view = detail::lay_out(detail::view_of(map.geometry, occupancy), "headings", 1).view;
  EXPECT_LE(difference(picture.at(view.to_pixel({1.3, 1.3})), alignability_colour(0.0, Tone::full)), kRounding) << "the worst";
  for (std::size_t k = 0; k < 4; ++k) {
    const detail::View small = detail::small_view(view, k, 4);
    EXPECT_LE(difference(picture.at(small.to_pixel({1.3, 1.3})), alignability_colour(map.layers[k + 1].values[0], Tone::full)), kRounding)
        << k;
  }
}

}  // namespace
}  // namespace alignability
