// SPDX-License-Identifier: BSD-3-Clause
// What maps/t_junction ships is what its makers make, and does what its README says.
#include <gmock/gmock.h>

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "alignability/build_map.hpp"
#include "core/file.hpp"
#include "costmap/heading_layers.hpp"
#include "costmap/map_server.hpp"
#include "lidar/lidar_model.hpp"
#include "lidar/sdf_world.hpp"
#include "planner/compare.hpp"
#include "planner/plan_problem.hpp"
#include "tests/core/temporary_folder.hpp"

namespace alignability {
namespace {

const std::filesystem::path kMaps = std::filesystem::path(ALIGNABILITY_SOURCE_DIR) / "maps";
const std::filesystem::path kSite = kMaps / "t_junction";
constexpr std::uintmax_t kLargest = 1 << 20;

TEST(TJunction, WorldIsWhatItsGeneratorWrites) {
  const test::TemporaryFolder folder;
  const std::filesystem::path made = folder / "t_junction.sdf";
  const std::string command = "python3 " + (kSite / "generate_world.py").string() + ' ' + made.string();
  ASSERT_EQ(std::system(command.c_str()), 0);
  EXPECT_EQ(read_file(made, kLargest), read_file(kSite / "t_junction.sdf", kLargest));
}

TEST(TJunction, AlignabilityMapIsRebuiltCellByCellAtEveryHeading) {
  const AlignabilityMap shipped = read_alignability_map(kSite / "alignability.yaml");
  const LidarModel lidar = read_lidar_model(kMaps / "sensors/hap.yaml");
  EXPECT_EQ(shipped.sensor, lidar.yaml);
  MapOptions options;
  options.samples = 1;
  options.range_max = 9.0;
  options.headings = 8;
  options.seed = shipped.seed;
  options.alignability = for_lidar(options.alignability, lidar);
  const GridGeometry& cells = shipped.geometry;
  options.cells = {*cells.cell_near({11.5, 0.5}), *cells.cell_near({-4.5, 2.5}), *cells.cell_near({18.5, 3.5})};
  const AlignabilityMap made = build_alignability_map(Scene(read_world(kSite / "t_junction.sdf").meshes),
                                                      read_occupancy_map(kSite / "occupancy.yaml"), lidar, options);
  const auto layers = heading_layers(made), shipped_layers = heading_layers(shipped);
  ASSERT_EQ(layers.size(), 8u);
  ASSERT_EQ(shipped_layers.size(), 8u);
  for (const Cell cell : *options.cells) {
    EXPECT_NEAR(made.alpha()[cell], shipped.alpha()[cell], 1e-6);
    for (std::size_t k = 0; k < layers.size(); ++k) EXPECT_NEAR((*layers[k])[cell], (*shipped_layers[k])[cell], 1e-6);
  }
}

TEST(TJunction, InTheAisleFacingTheJunctionScoresAboveFacingThePlainHall) {
  const AlignabilityMap map = read_alignability_map(kSite / "alignability.yaml");
  const auto layers = heading_layers(map);
  for (const double x : {11.5, 12.5, 13.5}) {
    const Cell cell = *map.geometry.cell_near({x, 0.0});
    const float junction = (*layers[nearest_heading(0.0, layers.size())])[cell];
    const float hall = (*layers[nearest_heading(std::numbers::pi, layers.size())])[cell];
    EXPECT_LT(hall, 0.05f) << x;
    EXPECT_GT(junction, 3.0f * hall) << x;
  }
}

TEST(TJunction, TheSafeWayThroughTheAisleIsBackwards) {
  ProblemFile file = read_problem_file(kSite / "problem.yaml");
  file.query.planner.time = 120.0;
  file.query.planner.iterations = 3000;
  const Comparison comparison = compare(load_problem(file), {});
  ASSERT_EQ(comparison.shortest.status, PlanStatus::solved);
  ASSERT_EQ(comparison.risk_aware.status, PlanStatus::solved);
  EXPECT_LT(comparison.risk_aware.figures.blind_length, 0.3 * comparison.shortest.figures.blind_length);
  int poses = 0;
  for (const Pose2& pose : comparison.risk_aware.path) {
    if (pose.x < 8.5 || pose.x > 13.5) continue;
    ++poses;
    EXPECT_GT(std::cos(pose.yaw), 0.5) << "within the 60 degrees to either side that the lidar sees, it faces the junction at x = "
                                       << pose.x;
  }
  EXPECT_GT(poses, 2);
}

}  // namespace
}  // namespace alignability
