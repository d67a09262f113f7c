// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/scan_picture.hpp"

#include <gmock/gmock.h>

#include <limits>

#include "core/pose.hpp"
#include "pictures/colour_map.hpp"
#include "pictures/page.hpp"
#include "tests/core/temporary_folder.hpp"
#include "tests/core/thrown_message.hpp"
#include "tests/costmap/ascii_map.hpp"
#include "tests/pictures/read_png.hpp"

namespace alignability {
namespace {

using namespace test;

struct Labelled {
  std::vector<Eigen::Vector3f> points;
  std::vector<int> planes;

  void add_wall(const Eigen::Vector3f& from, const Eigen::Vector3f& to, int plane) {
    constexpr int kPoints = 2000;
    for (int i = 0; i < kPoints; ++i) {
      points.push_back(from + static_cast<float>(i) / kPoints * (to - from));
      planes.push_back(plane);
    }
  }
};

// A wall ahead, plane 0, and one to the left, plane 1.
Labelled corner() {
  Labelled scan;
  scan.add_wall({8.0f, -8.0f, 0.0f}, {8.0f, 8.0f, 0.0f}, 0);
  scan.add_wall({-8.0f, 8.0f, 0.0f}, {7.9f, 8.0f, 0.0f}, 1);
  return scan;
}

// The middle of all pixels of that colour left of the legend and below nothing else that has it.
Eigen::Vector2d middle_of(const Picture& picture, const Colour& colour) {
  constexpr int kLegend = 300;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  int count = 0;
  for (int row = 0; row < picture.height(); ++row) {
    for (int column = 0; column < picture.width() - kLegend; ++column) {
      if (difference(picture.at(Eigen::Vector2d(column, row)), colour) > kRounding) continue;
      sum += Eigen::Vector2d(column, row);
      ++count;
    }
  }
  return sum / count;
}

class ScanPicture : public ::testing::Test {
 protected:
  Picture drawn(const Labelled& scan, const ScanPictureOptions& options = {}) {
    draw_scan(scan.points, scan.planes, options, folder_ / "scan.png");
    return Picture(folder_ / "scan.png");
  }
  TemporaryFolder folder_;
};

TEST_F(ScanPicture, ForwardIsToTheRightAndLeftIsUp) {
  const Picture picture = drawn(corner());
  const Eigen::Vector2d ahead = middle_of(picture, detail::category_colour(0));
  const Eigen::Vector2d left = middle_of(picture, detail::category_colour(1));
  EXPECT_GT(ahead.x(), left.x() + 300.0);
  EXPECT_LT(left.y(), ahead.y() - 300.0);
}

TEST_F(ScanPicture, APointOfNoPlaneIsGrey) {
  Labelled scan;
  scan.add_wall({5.0f, -5.0f, 0.0f}, {5.0f, 5.0f, 0.0f}, -1);
  const Picture picture = drawn(scan);
  EXPECT_EQ(picture.count(detail::category_colour(0)), 0);
  EXPECT_GT(picture.count(colour_from_hex(0xa8a8a8)), 500);
}

TEST_F(ScanPicture, PointsThatAreNotFiniteArePassedOver) {
  Labelled scan = corner();
  draw_scan(scan.points, scan.planes, {}, folder_ / "finite.png");
  constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  for (const Eigen::Vector3f& point : {Eigen::Vector3f(kNaN, 0.0f, 0.0f), Eigen::Vector3f(1.0f, kInfinity, 0.0f)}) {
    scan.points.push_back(point);
    scan.planes.push_back(0);
  }
  EXPECT_EQ(drawn(scan).width(), Picture(folder_ / "finite.png").width());
}

TEST_F(ScanPicture, TheWeakestDirectionIsDrawnToBothSidesOfTheSensor) {
  const int without = drawn(corner()).count(detail::kBlind);
  const int along_x =
      drawn(corner(), {.title = "", .lines = {}, .weakest_direction = Eigen::Vector3d(2.0, 0.0, 0.0), .range = {}}).count(detail::kBlind);
  const int upwards =
      drawn(corner(), {.title = "", .lines = {}, .weakest_direction = Eigen::Vector3d(0.0, 0.0, 1.0), .range = {}}).count(detail::kBlind);
  EXPECT_EQ(without, 0);
  EXPECT_GT(along_x, 1000);
  EXPECT_GT(upwards, 0) << "the legend says that it is vertical";
  EXPECT_LT(upwards, 500);
}

TEST_F(ScanPicture, ARangeLeavesOutWhatLiesBeyond) {
  const Picture picture = drawn(corner(), {.title = "", .lines = {}, .weakest_direction = {}, .range = 5.0});
  EXPECT_LT(picture.count(detail::category_colour(0)), 300) << "the legend's patch alone";
}

// The sensor at (30, 20), turned to the left: what was ahead of it, plane 0, is up.
TEST_F(ScanPicture, InMapTheScanIsTurnedAsTheSensorWas) {
  ScanPictureOptions options;
  options.T_map_lidar = Eigen::Translation3d(30.0, 20.0, 1.9) * Eigen::AngleAxisd(radians(90.0), Eigen::Vector3d::UnitZ());
  const Picture picture = drawn(corner(), options);
  const Eigen::Vector2d ahead = middle_of(picture, detail::category_colour(0));
  const Eigen::Vector2d left = middle_of(picture, detail::category_colour(1));
  EXPECT_LT(ahead.y(), left.y() - 300.0);
  EXPECT_LT(left.x(), ahead.x() - 300.0);
}

TEST_F(ScanPicture, InMapTheWallsAreDrawnBeneath) {
  const OccupancyMap occupancy = ascii_map(1.0, {"####", "...?", "...."}, {-2.0, 0.0});
  ScanPictureOptions options;
  options.occupancy = &occupancy;
  const Colour wall = detail::wall_colour(detail::Tone::pale);
  EXPECT_LT(drawn(corner(), options).count(wall), 100) << "but for edges of letters: its place in the map is not known";
  options.T_map_lidar = Eigen::Isometry3d::Identity();
  const Picture picture = drawn(corner(), options);
  EXPECT_GT(picture.count(wall), 5000);
  EXPECT_EQ(picture.count(detail::category_colour(0)), drawn(corner()).count(detail::category_colour(0))) << "and cover no point";
}

TEST_F(ScanPicture, TheLargestPlanesHaveColoursOfTheirOwnWhateverTheirNumbers) {
  Labelled scan;
  for (int plane = 0; plane < 13; ++plane) {
    const float x = static_cast<float>((plane + 1) % 13);
    const int walls = plane == 12 ? 2 : 1;
    for (int i = 0; i < walls; ++i) scan.add_wall({x, -5.0f, 0.0f}, {x, 5.0f, 0.0f}, plane);
  }
  const Picture picture = drawn(scan);
  const double largest = middle_of(picture, detail::category_colour(0)).x();
  EXPECT_GT(middle_of(picture, detail::category_colour(1)).x(), largest + 20.0) << "plane 12 is at the left, plane 0 beside it";
  EXPECT_GT(middle_of(picture, detail::mixed(detail::category_colour(12), detail::kWhite, 0.5)).x(), largest + 300.0) << "the last is pale";
}

TEST_F(ScanPicture, PlanesWithLabelsHaveAWiderKey) {
  ScanPictureOptions options;
  options.plane_labels = {"wall 180 deg: 51.3 %, holds 100.0 %"};
  EXPECT_GT(drawn(corner(), options).width(), drawn(corner()).width());
}

TEST_F(ScanPicture, AnEmptyScanAndAHundredPlanesAreDrawn) {
  EXPECT_GT(drawn({}).width(), 0);
  Labelled many;
  for (int plane = 0; plane < 100; ++plane) many.add_wall({1.0f, 0.1f * static_cast<float>(plane), 0.0f}, {3.0f, 0.0f, 0.0f}, plane);
  EXPECT_LT(drawn(many).height(), 2000);
}

TEST_F(ScanPicture, RefusesLabelsThatDoNotMatchAndARangeOfNothing) {
  Labelled scan = corner();
  scan.planes.pop_back();
  EXPECT_THROW(drawn(scan), std::invalid_argument);
  EXPECT_THROW(drawn(corner(), {.title = "", .lines = {}, .weakest_direction = {}, .range = 0.0}), std::invalid_argument);
  EXPECT_EQ(folder_.files(), 0);
}

TEST_F(ScanPicture, AFileThatCannotBeWrittenIsAnInputErrorThatNamesIt) {
  const auto png = folder_ / "absent/scan.png";
  EXPECT_THAT(thrown_message([&] { draw_scan({}, {}, {}, png); }), ::testing::StartsWith(png.string() + ": cannot be written"));
}

}  // namespace
}  // namespace alignability
