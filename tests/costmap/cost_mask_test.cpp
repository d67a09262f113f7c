// SPDX-License-Identifier: BSD-3-Clause
#include "costmap/cost_mask.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "costmap/map_server.hpp"
#include "costmap/map_table.hpp"
#include "tests/core/temporary_folder.hpp"

namespace alignability {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// What nav2's costmap makes of a percentage of a mask.
long cost_of(float occupancy) { return std::lround(std::round(100.0 * occupancy) * 254.0 / 100.0); }

TEST(CostMask, KeepsEveryGradeAsMapServerReadsIt) {
  const test::TemporaryFolder folder;
  const GridGeometry geometry{.resolution = 0.1, .origin = {-3.0, 2.0}, .width = kMostOfMask + 1, .height = 2};
  Grid<double> share(geometry, 0.0);
  for (int x = 0; x < geometry.width; ++x) share[Cell{x, 1}] = x / static_cast<double>(kMostOfMask);
  write_cost_mask(share, folder / "mask");
  const OccupancyMap mask = read_occupancy_map(folder / "mask.yaml");
  EXPECT_EQ(mask.geometry().origin, geometry.origin);
  for (int x = 0; x < geometry.width; ++x) {
    EXPECT_EQ(mask.occupancy({x, 0}), 0.0f);
    EXPECT_FLOAT_EQ(mask.occupancy({x, 1}).value(), static_cast<float>(x) / 100.0f);
  }
  EXPECT_EQ(cost_of(*mask.occupancy({kMostOfMask, 1})), kMostCostOfMask);
  EXPECT_LT(kMostCostOfMask, 253) << "neither lethal nor inscribed";
}

TEST(CostMask, IsLethalWhereNothingMayEnter) {
  const test::TemporaryFolder folder;
  write_cost_mask(Grid<double>({.resolution = 1.0, .width = 1, .height = 1}, kNan), folder / "m");
  EXPECT_EQ(cost_of(*read_occupancy_map(folder / "m.yaml").occupancy({0, 0})), 254);
}

TEST(CostMask, RefusesWhatIsNoShare) {
  const test::TemporaryFolder folder;
  for (const double share : {-0.1, 1.1}) {
    EXPECT_THROW(write_cost_mask(Grid<double>({.resolution = 1.0, .width = 1, .height = 1}, share), folder / "m"), std::invalid_argument);
  }
}

TEST(MapTable, HasALineForEachCellWithAValue) {
  AlignabilityMap map;
  map.geometry = {.resolution = 0.5, .origin = {10.0, 20.0}, .width = 2, .height = 2};
  map.layers = {{"alpha", Grid<float>(map.geometry, std::numeric_limits<float>::quiet_NaN())},
                {"samples", Grid<float>(map.geometry, std::numeric_limits<float>::quiet_NaN())}};
  map.layers[0].values[Cell{1, 0}] = 0.25f;
  map.layers[1].values[Cell{1, 0}] = 10.0f;
  map.layers[1].values[Cell{0, 1}] = 3.0f;
  EXPECT_EQ(to_csv(map), "x,y,alpha,samples\n10.75,20.25,0.25,10\n10.25,20.75,,3\n");
}

TEST(MapTable, WorldFileNamesTheCentreOfTheUpperLeftCell) {
  EXPECT_EQ(world_file({.resolution = 0.5, .origin = {10.0, 20.0}, .width = 4, .height = 2}), "0.5\n0\n0\n-0.5\n10.25\n20.75\n");
}

}  // namespace
}  // namespace alignability
