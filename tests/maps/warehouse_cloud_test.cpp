// SPDX-License-Identifier: BSD-3-Clause
// The warehouse as a point cloud: what is known of it by points alone against what is known of it by its surfaces.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "alignability/build_map.hpp"
#include "alignability/map_update.hpp"
#include "costmap/map_server.hpp"
#include "costmap/occupancy_patches.hpp"
#include "lidar/lidar_model.hpp"
#include "lidar/sample_surface.hpp"
#include "lidar/sdf_world.hpp"
#include "lidar/slice.hpp"

namespace alignability {
namespace {

const std::filesystem::path kMaps = std::filesystem::path(ALIGNABILITY_SOURCE_DIR) / "maps";
constexpr double kRangeMax = 6.5;

// The plain corridor between the packed aisles, and a piece of these on either side.
const std::vector<Eigen::Vector2d> kPart{{29.1, 20.1}, {30.9, 20.1}, {30.9, 25.9}, {29.1, 25.9}};

// A box that holds all that a lidar in the part sees.
const Eigen::AlignedBox3f kSeen(Eigen::Vector3f(22, 13, -1), Eigen::Vector3f(38, 33, 20));

DiscCloud sampled(const std::vector<TriangleMesh>& meshes) {
  PointCloud seen;
  for (const Eigen::Vector3f& point : sample_surface(meshes, {.spacing = 0.05}).points) {
    if (kSeen.contains(point)) seen.points.push_back(point);
  }
  return discs_of(seen);
}

class WarehouseCloud : public testing::Test {
 protected:
  std::vector<TriangleMesh> meshes = read_world(kMaps / "warehouse/warehouse.sdf").meshes;
  OccupancyMap occupancy = read_occupancy_map(kMaps / "warehouse/occupancy.yaml");
  DiscCloud discs = sampled(meshes);
};

TEST_F(WarehouseCloud, ItsMapIsNearlyThatOfTheWorld) {
  const LidarModel lidar = read_lidar_model(kMaps / "sensors/hdl32e.yaml");
  MapOptions options;
  options.samples = 1;
  options.range_max = kRangeMax;
  options.alignability = for_lidar(options.alignability, lidar);
  options.cells = cells_meeting(alignability_geometry(occupancy.geometry(), options.resolution), kPart);
  const AlignabilityMap truth = build_alignability_map(Scene(meshes), occupancy, lidar, options);
  const AlignabilityMap map = build_alignability_map(Scene({}, discs), occupancy, lidar, options);
  std::vector<float> errors;
  for (const Cell cell : *options.cells) {
    ASSERT_EQ(std::isnan(map.alpha()[cell]), std::isnan(truth.alpha()[cell])) << cell.x << ' ' << cell.y;
    if (!std::isnan(truth.alpha()[cell])) errors.push_back(std::abs(map.alpha()[cell] - truth.alpha()[cell]));
  }
  std::ranges::sort(errors);
  ASSERT_GE(errors.size(), 8u);
  EXPECT_LE(errors[errors.size() / 2], 0.03f);
  EXPECT_LE(errors.back(), 0.3f);
}

bool is_near_what_is_not_free(const OccupancyMap& map, Cell cell) {
  for (int dy = -2; dy <= 2; ++dy) {
    for (int dx = -2; dx <= 2; ++dx) {
      if (!map.is_free({cell.x + dx, cell.y + dy})) return true;
    }
  }
  return false;
}

// A face on the line between two cells shows in both, so what is free may be a cell narrower, and two where the floor has a hole beside it.
TEST_F(WarehouseCloud, ItsOccupancyHidesNothingAndIsNarrowerByTwoCellsAtMost) {
  const OccupancyMap filled = without_small_holes(rasterize(slice(discs, 0.1, 2.0), occupancy.geometry()), 0.1);
  const OccupancyMap map = without_small_patches(filled, 1.0);
  std::size_t free = 0;
  for (std::size_t i = 0; i < occupancy.geometry().size(); ++i) {
    const Cell cell = occupancy.geometry().cell_of(i);
    const Eigen::Vector2d center = occupancy.geometry().center(cell);
    if (std::abs(center.x() - 30.0) > 7.0 || std::abs(center.y() - 23.0) > 9.0) continue;
    free += map.is_free(cell) ? 1 : 0;
    if (map.is_free(cell)) {
      EXPECT_TRUE(occupancy.is_free(cell)) << center.transpose();
    }
    if (!filled.is_free(cell)) {
      EXPECT_TRUE(is_near_what_is_not_free(occupancy, cell)) << center.transpose();
    }
  }
  EXPECT_GT(free, 15000u);
}

}  // namespace
}  // namespace alignability
