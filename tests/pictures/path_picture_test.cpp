// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/path_picture.hpp"

#include <gmock/gmock.h>

#include "pictures/colour_map.hpp"
#include "pictures/map_layout.hpp"
#include "tests/core/temporary_folder.hpp"
#include "tests/core/thrown_message.hpp"
#include "tests/costmap/heading_maps.hpp"
#include "tests/pictures/read_png.hpp"
#include "tests/pictures/small_site.hpp"

namespace alignability {
namespace {

using namespace test;

constexpr double kHaloSide = 9.0;  // from a path's middle to where its halo is red [px]

DrawnPath eastward(double y, std::vector<ProfilePoint> profile) {
  return {.label = "path",
          .poses = {{0.5, y, 0.0}, {9.5, y, 0.0}},
          .profile = std::move(profile),
          .colour = kRiskAwareColour,
          .style = LineStyle::solid};
}

class PathPicture : public ::testing::Test {
 protected:
  Picture drawn(std::span<const DrawnPath> paths, const PathPictureOptions& options = {}) {
    draw_paths(map_, occupancy_, paths, options, folder_ / "paths.png");
    view_ = detail::lay_out(detail::view_of(map_.geometry, occupancy_), options.title, paths.empty() ? 0 : paths.size() + 1).view;
    return Picture(folder_ / "paths.png");
  }
  Eigen::Vector2d pixel(double x, double y) const { return view_.to_pixel({x, y}); }

  TemporaryFolder folder_;
  AlignabilityMap map_ = uniform_alpha_map({.width = 10, .height = 8}, 0.5f);
  OccupancyMap occupancy_ = OccupancyMap(Grid<float>({.resolution = 0.5, .width = 20, .height = 16}, 0.0f));
  detail::View view_;
};

TEST_F(PathPicture, APathIsDrawnInItsColourWhereItLies) {
  const std::vector<DrawnPath> paths = {eastward(4.0, {})};
  const Picture picture = drawn(paths);
  for (const double x : {0.7, 3.0, 9.3}) EXPECT_LE(difference(picture.at(pixel(x, 4.0)), kRiskAwareColour), kRounding);
  EXPECT_LE(difference(picture.at(pixel(3.0, 5.0)), detail::alignability_colour(0.5, detail::Tone::pale)), kRounding);
}

TEST_F(PathPicture, OfAMapByHeadingLiesOnTheBestOfThem) {
  map_ = heading_map(map_.geometry, 4, [](const Eigen::Vector2d&, double yaw) { return static_cast<float>(0.1 * yaw); });
  const Picture picture = drawn({});
  EXPECT_LE(difference(picture.at(pixel(3.0, 5.0)), detail::alignability_colour(map_.layers[4].values[0], detail::Tone::pale)), kRounding);
}

TEST_F(PathPicture, BlindStretchesAndOnlyTheyHaveAHalo) {
  const std::vector<DrawnPath> paths = {eastward(4.0, {{0.0, 0.5}, {2.9, 0.5}, {3.0, 0.0}, {6.0, 0.0}, {6.1, 0.5}, {9.0, 0.5}})};
  const Picture picture = drawn(paths);
  const Eigen::Vector2d aside(0.0, kHaloSide);
  EXPECT_LE(difference(picture.at(pixel(5.0, 4.0) + aside), detail::kBlind), kRounding);
  EXPECT_LE(difference(picture.at(pixel(5.0, 4.0) - aside), detail::kBlind), kRounding);
  EXPECT_LE(difference(picture.at(pixel(5.0, 4.0)), kRiskAwareColour), kRounding);
  EXPECT_GT(difference(picture.at(pixel(2.0, 4.0) + aside), detail::kBlind), 0.2);
  EXPECT_GT(difference(picture.at(pixel(8.0, 4.0) + aside), detail::kBlind), 0.2);
}

TEST_F(PathPicture, AProfileInOtherUnitsOfLengthStretchesOverTheWholePath) {
  const std::vector<DrawnPath> paths = {eastward(4.0, {{0.0, 0.5}, {44.9, 0.5}, {45.0, 0.0}, {90.0, 0.0}})};
  const Picture picture = drawn(paths);
  const Eigen::Vector2d aside(0.0, kHaloSide);
  EXPECT_LE(difference(picture.at(pixel(9.0, 4.0) + aside), detail::kBlind), kRounding);
  EXPECT_GT(difference(picture.at(pixel(4.5, 4.0) + aside), detail::kBlind), 0.2);
}

TEST_F(PathPicture, ADashedPathLetsTheSolidOneUnderItShowThrough) {
  std::vector<DrawnPath> paths = {eastward(4.0, {}), eastward(4.0, {})};
  paths[0].colour = kShortestColour;
  paths[0].style = LineStyle::dashed;
  const Picture picture = drawn(paths);
  int dashed = 0;
  int solid = 0;
  for (double x = 1.0; x < 9.0; x += 0.01) {
    dashed += difference(picture.at(pixel(x, 4.0)), kShortestColour) <= kRounding ? 1 : 0;
    solid += difference(picture.at(pixel(x, 4.0)), kRiskAwareColour) <= kRounding ? 1 : 0;
  }
  EXPECT_GT(dashed, 300);
  EXPECT_GT(solid, 150);
}

TEST_F(PathPicture, StartAndGoalAreMarked) {
  const Picture picture = drawn(
      {}, {.title = "", .risk = {}, .start = Pose2{2.0, 2.0, 0.0}, .goal = Pose2{8.0, 6.0, 0.0}, .robot_radius = 0.3, .footprint = {}});
  EXPECT_LE(difference(picture.at(pixel(2.0, 2.0)), detail::kWhite), kRounding);
  EXPECT_LE(difference(picture.at(pixel(8.0, 6.0)), detail::kInk), kRounding);
}

TEST_F(PathPicture, AFootprintTurnsWithItsPose) {
  const Pose2 upward{5.0, 3.0, radians(90)};
  const Picture picture = drawn({}, {.title = "",
                                     .risk = {},
                                     .start = upward,
                                     .goal = std::nullopt,
                                     .robot_radius = 0.0,
                                     .footprint = {{2.0, 0.5}, {-0.5, 0.5}, {-0.5, -0.5}, {2.0, -0.5}}});
  const Picture bare = drawn({});
  // Its front edge lies 2 m above the pose, and nothing of it to the right.
  EXPECT_GT(difference(picture.at(pixel(5.4, 4.9)), bare.at(pixel(5.4, 4.9))), 0.05);
  EXPECT_LE(difference(picture.at(pixel(6.5, 3.0)), bare.at(pixel(6.5, 3.0))), kRounding);
}

TEST_F(PathPicture, ARiskOfSeveralSourcesTakesThePlaceOfAlpha) {
  Grid<float> risk({.resolution = 1.0, .width = 10, .height = 8}, 0.0f);
  risk[Cell{3, 5}] = 1.5f;
  risk[Cell{6, 5}] = 0.75f;
  PathPictureOptions options;
  options.risk_map = risk;
  const Picture picture = drawn({}, options);
  const auto colour = [](double share) { return detail::alignability_colour(1.0 - share, detail::Tone::pale); };
  EXPECT_LE(difference(picture.at(pixel(3.5, 5.5)), colour(1.0)), kRounding);
  EXPECT_LE(difference(picture.at(pixel(6.5, 5.5)), colour(0.5)), kRounding);
  EXPECT_LE(difference(picture.at(pixel(8.5, 2.5)), colour(0.0)), kRounding);
}

TEST_F(PathPicture, WithoutPathsThereIsTheMapAlone) {
  const int alone = drawn({}).height();
  const std::vector<DrawnPath> paths = {eastward(4.0, {})};
  EXPECT_GT(drawn(paths).height(), alone + 200);
}

TEST_F(PathPicture, APathWithoutALabelIsOnTheMapAlone) {
  std::vector<DrawnPath> paths = {eastward(4.0, {{0.0, 0.5}, {9.0, 0.5}})};
  const int height = drawn(paths).height();
  paths.push_back(eastward(6.0, {{0.0, 0.5}, {9.0, 0.5}}));
  paths.back().label.clear();
  draw_paths(map_, occupancy_, paths, {}, folder_ / "unlabelled.png");
  const Picture picture(folder_ / "unlabelled.png");
  EXPECT_EQ(picture.height(), height);
  EXPECT_LE(difference(picture.at(pixel(3.0, 6.0)), kRiskAwareColour), kRounding);
}

TEST_F(PathPicture, ALabelWithoutPosesIsInTheKeyAlone) {
  std::vector<DrawnPath> paths = {eastward(4.0, {{0.0, 0.5}, {9.0, 0.5}}), eastward(6.0, {})};
  const int with_both = drawn(paths).height();
  paths[1].poses.clear();
  const int with_label = drawn(paths).height();
  paths.pop_back();
  EXPECT_LT(with_label, with_both);
  EXPECT_GT(with_label, drawn(paths).height());
}

TEST_F(PathPicture, APathBeyondTheMapIsCutOffAtItsFrame) {
  DrawnPath path = eastward(4.0, {{0.0, 0.0}, {1.0, 0.0}});
  path.poses = {{-1e9, 20.0, 0.0}, {1e9, 20.0, 0.0}};
  const std::vector<DrawnPath> paths = {path};
  const Picture picture = drawn(paths);
  for (double x = view_.frame.left + 2.0; x < view_.frame.right() - 2.0; x += 7.0) {
    EXPECT_GT(difference(picture.at({x, view_.frame.top + 3.0}), kRiskAwareColour), 0.1);
  }
}

TEST_F(PathPicture, PathsOfNoPoseOfOneAndOfOnePlaceAreDrawn) {
  std::vector<DrawnPath> paths = {eastward(4.0, {}), eastward(4.0, {{0.0, 0.0}}), eastward(4.0, {{0.0, 0.0}, {0.0, 0.0}})};
  paths[0].poses = {};
  paths[1].poses = {{1.0, 1.0, 0.0}};
  paths[2].poses = {{1.0, 1.0, 0.0}, {1.0, 1.0, 2.0}};
  EXPECT_GT(drawn(paths).width(), 0);
}

TEST_F(PathPicture, AProfileThatIsUnknownThroughoutIsDrawn) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<DrawnPath> paths = {eastward(4.0, {{0.0, nan}, {9.0, nan}})};
  const Picture picture = drawn(paths);
  EXPECT_LE(difference(picture.at(pixel(5.0, 4.0) + Eigen::Vector2d(0.0, kHaloSide)), detail::kBlind), kRounding);
}

TEST_F(PathPicture, AFileThatCannotBeWrittenIsAnInputErrorThatNamesIt) {
  const auto png = folder_ / "absent/paths.png";
  EXPECT_THAT(thrown_message([&] { draw_paths(map_, occupancy_, {}, {}, png); }),
              ::testing::StartsWith(png.string() + ": cannot be written"));
}

}  // namespace
}  // namespace alignability
