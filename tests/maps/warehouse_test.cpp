// SPDX-License-Identifier: BSD-3-Clause
// What maps/warehouse ships is what its makers make, and does what its README says.
#include <gmock/gmock.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "alignability/build_map.hpp"
#include "alignability/explanation.hpp"
#include "costmap/map_server.hpp"
#include "lidar/lidar_model.hpp"
#include "lidar/sdf_world.hpp"
#include "lidar/simulate_scan.hpp"
#include "lidar/slice.hpp"
#include "planner/compare.hpp"
#include "tests/core/temporary_folder.hpp"

namespace alignability {
namespace {

const std::filesystem::path kMaps = std::filesystem::path(ALIGNABILITY_SOURCE_DIR) / "maps";
const std::filesystem::path kSite = kMaps / "warehouse";

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(Warehouse, WorldIsWhatItsGeneratorWrites) {
  const test::TemporaryFolder folder;
  const std::filesystem::path made = folder / "warehouse.sdf";
  const std::string command = "python3 " + (kSite / "generate_world.py").string() + ' ' + made.string() + " >/dev/null";
  ASSERT_EQ(std::system(command.c_str()), 0);
  EXPECT_EQ(bytes_of(made), bytes_of(kSite / "warehouse.sdf"));
}

TEST(Warehouse, OccupancyIsTheWorldSliced) {
  const World world = read_world(kSite / "warehouse.sdf");
  EXPECT_TRUE(world.warnings.empty());
  const Slice band = slice(world.meshes, 0.1, 2.0);
  const OccupancyMap made = rasterize(band, geometry_around(band, 0.1));
  const OccupancyMap shipped = read_occupancy_map(kSite / "occupancy.yaml");
  ASSERT_EQ(made.geometry(), shipped.geometry());
  for (std::size_t i = 0; i < made.geometry().size(); ++i) {
    const Cell cell = made.geometry().cell_of(i);
    ASSERT_EQ(made.occupancy(cell), shipped.occupancy(cell)) << cell.x << ' ' << cell.y;
  }
}

TEST(Warehouse, AlignabilityMapIsRebuiltCellByCell) {
  const AlignabilityMap shipped = read_alignability_map(kSite / "alignability.yaml");
  const LidarModel lidar = read_lidar_model(kMaps / "sensors/hdl32e.yaml");
  EXPECT_EQ(shipped.sensor, lidar.yaml);
  MapOptions options;
  options.samples = static_cast<int>((*shipped.find_layer("samples"))[Cell{30, 22}]);
  options.range_max = 6.5;
  options.seed = shipped.seed;
  options.alignability.segmentation.range_min = lidar.range_min;
  std::vector<Cell> evaluated;
  for (std::size_t i = 0; i < shipped.geometry.size(); ++i) {
    if (!std::isnan(shipped.alpha()[i])) evaluated.push_back(shipped.geometry.cell_of(i));
  }
  ASSERT_GT(evaluated.size(), 1500u);
  options.cells.emplace();
  for (std::size_t k = 0; k < 20; ++k) options.cells->push_back(evaluated[k * evaluated.size() / 20]);
  const Scene scene(read_world(kSite / "warehouse.sdf").meshes);
  const AlignabilityMap rebuilt = build_alignability_map(scene, read_occupancy_map(kSite / "occupancy.yaml"), lidar, options);
  ASSERT_EQ(rebuilt.geometry, shipped.geometry);
  EXPECT_EQ(rebuilt.options, shipped.options);
  for (const Cell cell : *options.cells) {
    EXPECT_NEAR(rebuilt.alpha()[cell], shipped.alpha()[cell], 1e-3) << cell.x << ' ' << cell.y;
  }
}

// What maps/warehouse/README.md says of the plain corridor, the hall, the packed aisle and the goods lane.
TEST(Warehouse, PlacesAreExplainedByWhatIsThere) {
  const LidarModel lidar = read_lidar_model(kMaps / "sensors/hdl32e.yaml");
  const Scene scene(read_world(kSite / "warehouse.sdf").meshes);
  const auto explained = [&](double x, double y) {
    const Eigen::Isometry3d T_map_lidar = Eigen::Translation3d(x, y, 0.0) * lidar.T_base_lidar;
    const Scan scan = simulate_scan(scene, lidar, T_map_lidar, {.range_max = 6.5}, NoiseKey{.seed = 1});
    return explain(scan, T_map_lidar.linear(), lidar.range_stddev, {});
  };
  const auto distances = [](const Explanation& explanation, PlaneKind kind) {
    std::vector<double> result;
    for (const ExplainedPlane& plane : explanation.planes) {
      if (plane.kind == kind && plane.share >= 0.01) result.push_back(plane.distance);
    }
    return result;
  };
  const auto near = [](double distance) { return testing::DoubleNear(distance, 0.03); };

  const Explanation corridor = explained(30.0, 22.3);
  EXPECT_THAT(distances(corridor, PlaneKind::wall), testing::UnorderedElementsAre(near(1.3), near(1.7)));
  EXPECT_THAT(distances(corridor, PlaneKind::floor), testing::ElementsAre(near(1.9)));
  EXPECT_THAT(sentence(corridor, {}), testing::HasSubstr("Blind, alpha 0.0"));
  EXPECT_THAT(sentence(corridor, {}), testing::HasSubstr("nothing faces along x:"));

  const Explanation hall = explained(11.5, 35.0);
  EXPECT_EQ(hall.planes.size(), 1u);
  EXPECT_THAT(sentence(hall, {}), testing::HasSubstr("nothing faces in any horizontal direction: the normals are of floor (100.0 %"));

  const Explanation packed = explained(32.0, 30.2);
  EXPECT_THAT(distances(packed, PlaneKind::wall), testing::ElementsAre(near(1.6), near(1.6)));
  EXPECT_THAT(distances(packed, PlaneKind::floor), testing::ElementsAre(near(1.9), near(0.5)))
      << "and the tops of the lower loads, at 1.4 m";
  EXPECT_THAT(sentence(packed, {}), testing::HasSubstr("nothing faces along x:"));

  const Explanation lane = explained(30.0, 10.0);
  EXPECT_THAT(sentence(lane, {}), testing::StartsWith("Safe, "));
  EXPECT_THAT(distances(lane, PlaneKind::wall), testing::IsSupersetOf({near(4.8), near(5.8), near(0.55), near(2.55)})) << "walls, columns";
}

TEST(Warehouse, ShortestPathIsBlindInTheCorridorAndTheRiskAwareOneGoesAround) {
  PlanProblem problem = load_problem(read_problem_file(kSite / "problem.yaml"));
  problem.query.planner.iterations = 20000;  // rather than the file's 5 s, of which a sanitizer takes most
  const Comparison comparison = compare(problem, {});
  ASSERT_EQ(comparison.shortest.status, PlanStatus::solved);
  ASSERT_EQ(comparison.risk_aware.status, PlanStatus::solved);
  EXPECT_GT(comparison.shortest.figures.blind_length, 25.0);
  EXPECT_LE(comparison.risk_aware.figures.blind_length, 0.1 * comparison.shortest.figures.blind_length);
  EXPECT_LE(comparison.risk_aware.figures.length, 1.5 * comparison.shortest.figures.length);
}

TEST(Sensors, AreThoseOfTheirDataSheets) {
  const LidarModel hdl32e = read_lidar_model(kMaps / "sensors/hdl32e.yaml");
  EXPECT_EQ(hdl32e.rings(), 32);
  EXPECT_EQ(hdl32e.columns(), 2170);
  EXPECT_NEAR(degrees(hdl32e.elevations[1] - hdl32e.elevations[0]), 4.0 / 3.0, 0.01);
  const LidarModel os1 = read_lidar_model(kMaps / "sensors/os1-64.yaml");
  EXPECT_EQ(os1.rings(), 64);
  EXPECT_EQ(os1.columns(), 1024);
  const LidarModel vlp16 = read_lidar_model(kMaps / "sensors/vlp16.yaml");
  EXPECT_EQ(vlp16.rings(), 16);
  EXPECT_NEAR(degrees(vlp16.elevations.back() - vlp16.elevations.front()), 30.0, 1e-9);
}

}  // namespace
}  // namespace alignability
