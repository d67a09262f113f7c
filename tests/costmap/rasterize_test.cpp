// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <limits>
#include <numbers>

#include "tests/costmap/ascii_map.hpp"

namespace alignability {
namespace {

using test::drawn;
using ::testing::ElementsAre;

ConvexPolygon rectangle(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

std::vector<DirectedEdge> loop(const std::vector<Eigen::Vector2d>& corners) {
  std::vector<DirectedEdge> edges;
  for (std::size_t i = 0; i < corners.size(); ++i) edges.push_back({corners[i], corners[(i + 1) % corners.size()]});
  return edges;
}

std::vector<DirectedEdge> reversed(std::vector<DirectedEdge> edges) {
  for (DirectedEdge& edge : edges) std::swap(edge.from, edge.to);
  return edges;
}

std::vector<DirectedEdge> operator+(std::vector<DirectedEdge> a, const std::vector<DirectedEdge>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

const GridGeometry kSix{.resolution = 1.0, .width = 6, .height = 6};

TEST(Rasterize, KnowsNothingOfAnEmptySlice) {
  EXPECT_THAT(drawn(rasterize({}, {.resolution = 1.0, .width = 2, .height = 2})), ElementsAre("??", "??"));
}

TEST(Rasterize, IsFreeWhereThereIsFloorBeneathTheCentre) {
  const Slice slice{.surfaces = {}, .solid_edges = {}, .floors = {rectangle(1.4, 1.6, 4.6, 3.4)}};
  EXPECT_THAT(drawn(rasterize(slice, kSix)), ElementsAre("??????", "??????", "??????", "?....?", "??????", "??????"));
}

TEST(Rasterize, PutsASurfaceBeforeAFloorAndAFloorBeforeTheUnknown) {
  const Slice slice{.surfaces = {{{2.5, 2.5}}}, .solid_edges = {}, .floors = {rectangle(1, 1, 5, 4)}};
  EXPECT_THAT(drawn(rasterize(slice, kSix)), ElementsAre("??????", "??????", "?....?", "?.#..?", "?....?", "??????"));
}

TEST(Rasterize, MeetsAnyCellThatASurfaceHasAPointIn) {
  const Slice slice{.surfaces = {rectangle(1.9, 2.9, 3.1, 3.1)}, .solid_edges = {}, .floors = {}};
  EXPECT_THAT(drawn(rasterize(slice, kSix)), ElementsAre("??????", "??????", "?###??", "?###??", "??????", "??????"));
}

TEST(Rasterize, GivesAPointOnALineToTheUpperRightCell) {
  const Slice slice{.surfaces = {{{2.0, 3.0}}}, .solid_edges = {}, .floors = {}};
  EXPECT_THAT(drawn(rasterize(slice, kSix)), ElementsAre("??????", "??????", "??#???", "??????", "??????", "??????"));
}

TEST(Rasterize, DoesNotSpillOverALineOnTheLeftAndBelow) {
  const Slice slice{.surfaces = {rectangle(2.0, 3.0, 3.5, 4.5)}, .solid_edges = {}, .floors = {}};
  EXPECT_THAT(drawn(rasterize(slice, kSix)), ElementsAre("??????", "??##??", "??##??", "??????", "??????", "??????"));
}

TEST(Rasterize, GivesAWallOnALineToOneColumn) {
  const Slice slice{.surfaces = {{{2.0, 0.5}, {2.0, 4.5}}}, .solid_edges = {}, .floors = {}};
  EXPECT_THAT(drawn(rasterize(slice, kSix)), ElementsAre("??????", "??#???", "??#???", "??#???", "??#???", "??#???"));
}

TEST(Rasterize, FillsASolid) {
  const Slice slice{.surfaces = {}, .solid_edges = loop(rectangle(1.2, 1.2, 4.8, 4.8)), .floors = {rectangle(0, 0, 6, 6)}};
  EXPECT_THAT(drawn(rasterize(slice, kSix)), ElementsAre("......", ".####.", ".####.", ".####.", ".####.", "......"));
}

TEST(Rasterize, LeavesAHoleOfOppositeWinding) {
  const auto ring = loop(rectangle(0, 0, 6, 6)) + reversed(loop(rectangle(2, 2, 4, 4)));
  EXPECT_THAT(drawn(rasterize({.surfaces = {}, .solid_edges = ring, .floors = {rectangle(0, 0, 6, 6)}}, kSix)),
              ElementsAre("######", "######", "##..##", "##..##", "######", "######"));
}

TEST(Rasterize, FillsASolidWithinASolidAndOnesThatOverlap) {
  const auto nested = loop(rectangle(0, 0, 6, 6)) + loop(rectangle(2, 2, 4, 4));
  EXPECT_THAT(drawn(rasterize({.surfaces = {}, .solid_edges = nested, .floors = {}}, kSix)), ::testing::Each("######"));
  const auto in_hole = loop(rectangle(0, 0, 6, 6)) + reversed(loop(rectangle(1, 1, 5, 5))) + loop(rectangle(2, 2, 4, 4));
  EXPECT_THAT(drawn(rasterize({.surfaces = {}, .solid_edges = in_hole, .floors = {}}, kSix)),
              ElementsAre("######", "#????#", "#?##?#", "#?##?#", "#????#", "######"));
  const auto overlapping = loop(rectangle(0, 0, 4, 4)) + loop(rectangle(2, 2, 6, 6));
  EXPECT_THAT(drawn(rasterize({.surfaces = {}, .solid_edges = overlapping, .floors = {}}, kSix)),
              ElementsAre("??####", "??####", "######", "######", "####??", "####??"));
}

TEST(Rasterize, DoesNotFillWhatIsWoundClockwise) {
  const auto clockwise = reversed(loop(rectangle(1, 1, 5, 5)));
  EXPECT_THAT(drawn(rasterize({.surfaces = {}, .solid_edges = clockwise, .floors = {}}, kSix)), ::testing::Each("??????"));
}

TEST(Rasterize, FillsASolidThatReachesBeyondTheMap) {
  const auto huge = loop(rectangle(-1e9, -1e9, 3, 1e9));
  EXPECT_THAT(drawn(rasterize({.surfaces = {}, .solid_edges = huge, .floors = {}}, kSix)), ::testing::Each("###???"));
  const Slice surface{.surfaces = {rectangle(-1e12, 2.5, 1e12, 2.5)}, .solid_edges = {}, .floors = {rectangle(-1e12, -1e12, 1e12, 1e12)}};
  EXPECT_THAT(drawn(rasterize(surface, kSix)), ElementsAre("......", "......", "......", "######", "......", "......"));
}

TEST(Rasterize, LeavesOutWhatLiesOffTheMap) {
  const Slice slice{.surfaces = {rectangle(7, 7, 9, 9), rectangle(-5, 1, -1, 2), {{3, -4}, {3, -1}}, {}},
                    .solid_edges = loop(rectangle(8, 0, 9, 6)),
                    .floors = {}};
  EXPECT_THAT(drawn(rasterize(slice, kSix)), ::testing::Each("??????"));
}

TEST(Rasterize, FillsADiskWhereItsCentresAre) {
  std::vector<Eigen::Vector2d> circle;
  constexpr int kCorners = 720;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kCorners;
    circle.emplace_back(5.03 + 4.0 * std::cos(angle), 4.96 + 4.0 * std::sin(angle));
  }
  const GridGeometry geometry{.resolution = 0.1, .width = 100, .height = 100};
  const OccupancyMap solid = rasterize({.surfaces = {}, .solid_edges = loop(circle), .floors = {}}, geometry);
  const OccupancyMap floor = rasterize({.surfaces = {}, .solid_edges = {}, .floors = {circle}}, geometry);
  for (std::size_t i = 0; i < geometry.size(); ++i) {
    const Cell cell = geometry.cell_of(i);
    const double away = (geometry.center(cell) - Eigen::Vector2d(5.03, 4.96)).norm();
    if (std::abs(away - 4.0) < 1e-3) continue;
    EXPECT_EQ(solid.occupancy(cell).has_value(), away < 4.0);
    EXPECT_EQ(floor.is_free(cell), away < 4.0);
  }
}

// Cells that a flood from the left border reaches over edges and corners.
bool flood_reaches_the_right(const OccupancyMap& map, bool across_corners) {
  const GridGeometry& geometry = map.geometry();
  std::vector<char> reached(geometry.size(), 0);
  std::vector<Cell> front;
  for (int y = 0; y < geometry.height; ++y) front.push_back({0, y});
  while (!front.empty()) {
    const Cell at = front.back();
    front.pop_back();
    if (!geometry.contains(at) || map.occupancy(at).value_or(0.0f) > 0.5f || reached[geometry.index(at)] != 0) continue;
    reached[geometry.index(at)] = 1;
    if (at.x == geometry.width - 1) return true;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        if (across_corners || dx == 0 || dy == 0) front.push_back({at.x + dx, at.y + dy});
      }
    }
  }
  return false;
}

TEST(Rasterize, LeavesNoGapInAWallWhateverItsDirection) {
  constexpr std::uint64_t kSeed = 31;
  SCOPED_TRACE(kSeed);
  std::mt19937_64 random(kSeed);
  std::uniform_real_distribution<double> place(0.5, 9.5);
  for (int i = 0; i < 300; ++i) {
    const double resolution = i % 2 == 0 ? 0.1 : 0.25;
    const GridGeometry geometry{
        .resolution = resolution, .width = static_cast<int>(10 / resolution), .height = static_cast<int>(10 / resolution)};
    Eigen::Vector2d from(place(random), -0.5);
    Eigen::Vector2d to(place(random), 10.5);
    if (i % 3 == 1) from.x() = to.x() = std::round(from.x() / resolution) * resolution;  // along a line of the grid
    if (i % 3 == 2) {                                                                    // through the corners of cells
      from = {0.0, 0.0};
      to = {10.0, 10.0};
      if (i % 4 < 2) std::swap(from.x(), to.x());
    }
    const OccupancyMap map = rasterize({.surfaces = {{from, to}}, .solid_edges = {}, .floors = {}}, geometry);
    EXPECT_FALSE(flood_reaches_the_right(map, true)) << from.transpose() << " to " << to.transpose() << " at " << resolution;
  }
}

TEST(Rasterize, LeavesNoGapBetweenPiecesOfAWallThatShareAnEnd) {
  constexpr std::uint64_t kSeed = 32;
  SCOPED_TRACE(kSeed);
  std::mt19937_64 random(kSeed);
  std::uniform_real_distribution<double> place(2.0, 8.0);
  for (int i = 0; i < 200; ++i) {
    const GridGeometry geometry{.resolution = 0.1, .width = 100, .height = 100};
    Slice slice;
    Eigen::Vector2d last(place(random), -0.1);
    for (const double y : {1.0, 2.5, 2.5, 4.05, 7.0, 6.0, 10.1}) {
      const Eigen::Vector2d next(place(random), y);
      slice.surfaces.push_back({last, next});
      last = next;
    }
    EXPECT_FALSE(flood_reaches_the_right(rasterize(slice, geometry), true)) << i;
  }
}

TEST(GeometryAround, HoldsEverySurface) {
  const Slice slice{.surfaces = {rectangle(-1.25, 0.3, 2.7, 0.9)}, .solid_edges = {}, .floors = {rectangle(-100, -100, 100, 100)}};
  const GridGeometry geometry = geometry_around(slice, 0.5);
  EXPECT_EQ(geometry.resolution, 0.5);
  EXPECT_EQ(geometry.origin, Eigen::Vector2d(-1.5, 0.0));
  EXPECT_EQ(geometry.width, 9) << "-1.5 to 3";
  EXPECT_EQ(geometry.height, 2) << "0 to 1";
}

TEST(GeometryAround, TakesDecimalsThatEndOnALineForWhatTheyAre) {
  // 0.3 / 0.1 is a little less than 3, and 0.7 / 0.1 than 7.
  const GridGeometry geometry = geometry_around({.surfaces = {rectangle(0.3, -0.3, 0.7, 0.7)}, .solid_edges = {}, .floors = {}}, 0.1);
  EXPECT_NEAR(geometry.origin.x(), 0.3, 1e-12);
  EXPECT_NEAR(geometry.origin.y(), -0.3, 1e-12);
  EXPECT_EQ(geometry.width, 4);
  EXPECT_EQ(geometry.height, 10);
}

TEST(GeometryAround, RefusesASliceWithoutSurfacesOrOneTooLarge) {
  EXPECT_THROW(geometry_around({}, 0.1), std::invalid_argument);
  EXPECT_THROW(geometry_around({.surfaces = {}, .solid_edges = {}, .floors = {rectangle(0, 0, 1, 1)}}, 0.1), std::invalid_argument);
  EXPECT_THROW(geometry_around({.surfaces = {rectangle(0, 0, 1e6, 1e6)}, .solid_edges = {}, .floors = {}}, 0.1), std::invalid_argument);
  EXPECT_THROW(geometry_around({.surfaces = {rectangle(0, 0, 1e300, 1)}, .solid_edges = {}, .floors = {}}, 0.1), std::invalid_argument);
  EXPECT_THROW(geometry_around({.surfaces = {rectangle(0, 0, 1, 1)}, .solid_edges = {}, .floors = {}}, 0.0), std::invalid_argument);
  EXPECT_THROW(
      geometry_around({.surfaces = {rectangle(0, 0, 1, 1)}, .solid_edges = {}, .floors = {}}, std::numeric_limits<double>::quiet_NaN()),
      std::invalid_argument);
}

TEST(OccupancyMap, RefusesWhatIsNoProbability) {
  for (const float value : {-0.01f, 1.01f, std::numeric_limits<float>::infinity()}) {
    EXPECT_THROW(OccupancyMap(Grid<float>({.resolution = 1.0, .width = 1, .height = 1}, value)), std::invalid_argument);
  }
}

TEST(OccupancyMap, IsFreeNowhereBeyondItsCells) {
  const OccupancyMap map = test::ascii_map(1.0, {"..", ".."});
  EXPECT_TRUE(map.is_free(Cell{1, 1}));
  for (const Cell cell : {Cell{-1, 0}, Cell{2, 0}, Cell{0, -1}, Cell{0, 2}}) EXPECT_FALSE(map.is_free(cell));
}

}  // namespace
}  // namespace alignability
