// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/map_update.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace alignability {
namespace {

const GridGeometry kGrid{.resolution = 0.5, .origin = {10.0, -2.0}, .width = 8, .height = 6};

AlignabilityMap map_of(float value) {
  AlignabilityMap map;
  map.geometry = kGrid;
  for (const char* name : {"alpha", "samples"}) map.layers.push_back({name, Grid<float>(map.geometry, value)});
  map.seed = 3;
  map.options = "samples: 3\n";
  map.sensor = "name: a\n";
  return map;
}

std::vector<std::pair<int, int>> meeting(const std::vector<Eigen::Vector2d>& polygon) {
  std::vector<std::pair<int, int>> cells;
  for (const Cell cell : cells_meeting(kGrid, polygon)) cells.emplace_back(cell.x, cell.y);
  return cells;
}

TEST(CellsMeeting, AreThoseThatAPolygonTouchesEitherWayRound) {
  const std::vector<std::pair<int, int>> expected{{1, 1}, {2, 1}, {1, 2}};
  EXPECT_THAT(meeting({{10.6, -1.4}, {11.2, -1.4}, {10.6, -0.8}}), testing::ElementsAreArray(expected));
  EXPECT_THAT(meeting({{10.6, -0.8}, {11.2, -1.4}, {10.6, -1.4}}), testing::ElementsAreArray(expected));
}

TEST(CellsMeeting, HoldThoseThatAPolygonLiesInOrAround) {
  EXPECT_THAT(meeting({{10.1, -1.9}, {10.2, -1.9}, {10.1, -1.8}}), testing::ElementsAre(std::pair(0, 0)));
  EXPECT_EQ(meeting({{0.0, -9.0}, {99.0, -9.0}, {99.0, 9.0}, {0.0, 9.0}}).size(), kGrid.size());
}

TEST(CellsMeeting, AreNoneOffTheMap) { EXPECT_TRUE(meeting({{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}}).empty()); }

TEST(CellsMeeting, OfWhatIsNoPolygonAreRefused) {
  EXPECT_THROW(cells_meeting(kGrid, std::vector<Eigen::Vector2d>{{10.0, 0.0}, {11.0, 0.0}}), std::invalid_argument);
  EXPECT_THROW(cells_meeting(kGrid, std::vector<Eigen::Vector2d>{{10.0, 0.0}, {11.0, 0.0}, {std::nan(""), 0.0}}), std::invalid_argument);
}

TEST(Updated, TakesTheRebuiltCellsWithAValueOrWithoutAndLeavesTheRest) {
  AlignabilityMap rebuilt = map_of(0.2f);
  rebuilt.layers[0].values[Cell{1, 0}] = std::numeric_limits<float>::quiet_NaN();
  rebuilt.provenance = "scene: new.sdf\n";
  const std::vector<Cell> cells{{0, 0}, {1, 0}};
  const AlignabilityMap map = updated(map_of(0.7f), rebuilt, cells);
  EXPECT_EQ(map.provenance, "scene: new.sdf\n");
  EXPECT_TRUE((std::isnan(map.alpha()[Cell{1, 0}])));
  EXPECT_EQ((map.layers[1].values[Cell{1, 0}]), 0.2f);
  int old = 0;
  for (const float value : map.alpha().values()) old += value == 0.7f ? 1 : 0;
  EXPECT_EQ(old, static_cast<int>(kGrid.size()) - 2);
}

TEST(Updated, RefusesMapsThatWereNotMadeAlike) {
  const auto refusal = [](auto change) -> std::string {
    AlignabilityMap before = map_of(0.7f);
    change(before);
    try {
      updated(before, map_of(0.2f), {});
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal([](AlignabilityMap&) {}), "");
  EXPECT_THAT(refusal([](AlignabilityMap& map) { map.geometry.origin.x() += 0.1; }), testing::HasSubstr("another grid"));
  EXPECT_THAT(refusal([](AlignabilityMap& map) { map.sensor = "name: b\n"; }), testing::HasSubstr("another sensor file"));
  EXPECT_THAT(refusal([](AlignabilityMap& map) { map.seed = 4; }), testing::HasSubstr("the seed 4, not 3"));
  EXPECT_THAT(refusal([](AlignabilityMap& map) { map.options = "samples: 4\n"; }), testing::HasSubstr("'samples: 4', not 'samples: 3'"));
  EXPECT_THAT(refusal([](AlignabilityMap& map) { map.layers.pop_back(); }), testing::HasSubstr("other layers"));
}

}  // namespace
}  // namespace alignability
