// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "costmap/clearance_map.hpp"
#include "costmap/map_server.hpp"
#include "tests/core/temporary_folder.hpp"
#include "tests/costmap/ascii_map.hpp"
#include "tests/shared_data.hpp"

namespace alignability {
namespace {

struct Census {
  std::size_t free = 0;
  std::size_t occupied = 0;
  std::size_t unknown = 0;

  std::size_t total() const { return free + occupied + unknown; }
};

Census census(const OccupancyMap& map) {
  Census counts;
  for (std::size_t i = 0; i < map.geometry().size(); ++i) {
    const auto occupancy = map.occupancy(map.geometry().cell_of(i));
    ++(!occupancy ? counts.unknown : *occupancy > OccupancyMap::kOccupiedAbove ? counts.occupied : counts.free);
  }
  return counts;
}

// What must hold of any map of a site; returns how many cells are what.
Census expect_a_site(const OccupancyMap& map, int width, int height, double resolution, const Eigen::Vector2d& origin) {
  EXPECT_EQ(map.geometry(), (GridGeometry{.resolution = resolution, .origin = origin, .width = width, .height = height}));
  const test::TemporaryFolder folder;
  write_occupancy_map(map, folder / "copy");
  EXPECT_EQ(test::drawn(read_occupancy_map(folder / "copy.yaml")), test::drawn(map));
  const ClearanceMap clearance(map);
  for (std::size_t i = 0; i < map.geometry().size(); i += 101) {
    const Cell cell = map.geometry().cell_of(i);
    EXPECT_EQ(clearance.distance(map.geometry().center(cell)) > 0.0, map.is_free(cell));
  }
  return census(map);
}

TEST(SharedMaps, ReadsTheWarehouseOfNav2) {
  ALIGNABILITY_REQUIRE_SHARED_DATA(file, "maps/nav2/warehouse.yaml");
  const Census counts = expect_a_site(read_occupancy_map(file), 1006, 1674, 0.03, {-15.1, -25.0});
  EXPECT_GT(counts.free, counts.total() / 4);
  EXPECT_GT(counts.occupied, counts.total() / 100);
}

TEST(SharedMaps, ReadsAMapWhereBlackIsFree) {
  ALIGNABILITY_REQUIRE_SHARED_DATA(file, "maps/nav2/100by100_10.yaml");
  const Census counts = expect_a_site(read_occupancy_map(file), 2000, 2000, 0.05, {0.0, 0.0});
  EXPECT_GT(counts.free, counts.occupied);
  EXPECT_GT(counts.occupied, 0u);
}

TEST(SharedMaps, ReadsThePngOfTheAwsWarehouse) {
  ALIGNABILITY_REQUIRE_SHARED_DATA(file, "worlds/aws-small-warehouse/maps_005/map.yaml");
  const Census counts = expect_a_site(read_occupancy_map(file), 286, 423, 0.05, {-7.0, -10.5});
  EXPECT_GT(counts.free, counts.total() / 3);
  EXPECT_GT(counts.occupied, 0u);
  EXPECT_GT(counts.unknown, 0u) << "grey 205 at free_thresh 0.196";
}

TEST(SharedMaps, ReadsTheMapOfCsail) {
  ALIGNABILITY_REQUIRE_SHARED_DATA(file, "logs/csail-2d/csail.corrected_derived_map.yaml");
  const Census counts = expect_a_site(read_occupancy_map(file), 1004, 1372, 0.05, {-10.55, -23.3});
  EXPECT_GT(counts.free, 0u);
  EXPECT_GT(counts.occupied, 0u);
  EXPECT_GT(counts.unknown, 0u);
}

}  // namespace
}  // namespace alignability
