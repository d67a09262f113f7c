// SPDX-License-Identifier: BSD-3-Clause
// The slice of a world against the map that a simulated robot made of the same world by SLAM.
#include <gtest/gtest.h>

#include "costmap/map_server.hpp"
#include "costmap/occupancy_difference.hpp"
#include "lidar/sdf_world.hpp"
#include "lidar/slice.hpp"
#include "pictures/occupancy_difference_picture.hpp"
#include "tests/shared_data.hpp"

namespace alignability {
namespace {

// The map's origin is rounded to decimetres, its image was turned by hand: it lies this far off the world, as walls and shelves show.
const Eigen::Vector2d kOffset(0.10, 0.15);

// The height of the robot's lidar is not told. Its map shows the mast of the pallet jack and not its forks, which end at 0.18 m, and
// the shelves' feet and not their lowest boards, from 0.73 m on; between these the slice hardly changes. Simulated beams meet collision
// shapes.
constexpr double kZMin = 0.29;
constexpr double kZMax = 0.31;

OccupancyMap moved(const OccupancyMap& map, const Eigen::Vector2d& offset) {
  GridGeometry geometry = map.geometry();
  geometry.origin += offset;
  Grid<float> occupancy(geometry, std::numeric_limits<float>::quiet_NaN());
  for (std::size_t i = 0; i < geometry.size(); ++i) occupancy[i] = map.occupancy(geometry.cell_of(i)).value_or(occupancy[i]);
  return OccupancyMap(std::move(occupancy));
}

TEST(SmallWarehouse, ItsSliceIsTheMapThatSlamMadeOfIt) {
  ALIGNABILITY_REQUIRE_SHARED_DATA(folder, "worlds/aws-small-warehouse");
  const OccupancyMap slam = moved(read_occupancy_map(folder / "maps_005/map.yaml"), kOffset);
  const World world = read_world(folder / "worlds/no_roof_small_warehouse.world");
  const OccupancyMap sliced = rasterize(slice(world.meshes, kZMin, kZMax), slam.geometry());
  const OccupancyDifference difference = occupancy_difference(slam, sliced);
  draw_occupancy_difference(difference, {.title = "AWS small warehouse", .first = "the SLAM map", .second = "the slice"},
                            "small_warehouse_difference.png");
  EXPECT_GT(difference.compared, slam.geometry().size() * 3 / 4);
  EXPECT_GE(difference.agreement(), 0.97) << "see small_warehouse_difference.png";
}

}  // namespace
}  // namespace alignability
