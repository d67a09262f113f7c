// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/disc_cloud.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "lidar/sample_surface.hpp"
#include "lidar/scene.hpp"
#include "lidar/simulate_scan.hpp"
#include "lidar/slice.hpp"
#include "tests/lidar/fixtures.hpp"

namespace alignability {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

// A lattice in the plane z = height, from 0 to 1 m along x and y, its first corner at the origin.
std::vector<Eigen::Vector3f> lattice(float spacing, float height = 0.0f) {
  std::vector<Eigen::Vector3f> points;
  const int count = static_cast<int>(std::lround(1.0f / spacing));
  for (int y = 0; y <= count; ++y) {
    for (int x = 0; x <= count; ++x) points.emplace_back(spacing * x, spacing * y, height);
  }
  return points;
}

TEST(DiscCloud, DiscsOfAPlaneLieInIt) {
  const DiscCloud discs = discs_of({.points = lattice(0.1f, 2.0f), .normals = {}});
  ASSERT_EQ(discs.size(), 121u);
  for (std::size_t i = 0; i < discs.size(); ++i) {
    EXPECT_EQ(discs.centers[i].z(), 2.0f);
    EXPECT_NEAR(std::abs(discs.normals[i].z()), 1.0f, 1e-5f);
  }
  EXPECT_NEAR(bounds(discs).sizes().z(), 0.0f, 1e-3f);
}

TEST(DiscCloud, RadiiFollowTheSpacing) {
  std::vector<Eigen::Vector3f> points = lattice(0.05f);
  for (const Eigen::Vector3f& point : lattice(0.1f)) points.emplace_back(point.x() + 5.0f, point.y(), 0.0f);
  const DiscCloud discs = discs_of({.points = points, .normals = {}});
  for (std::size_t i = 0; i < discs.size(); ++i) {
    const Eigen::Vector3f& center = discs.centers[i];
    const float x = center.x() < 2.0f ? center.x() : center.x() - 5.0f;
    if (std::max(std::abs(x - 0.5f), std::abs(center.y() - 0.5f)) > 0.25f) continue;
    EXPECT_NEAR(discs.radii[i], 0.8f * std::sqrt(2.0f) * (center.x() < 2.0f ? 0.05f : 0.1f), 1e-4f);
  }
}

TEST(DiscCloud, AStrayPointIsNoWall) {
  std::vector<Eigen::Vector3f> points = lattice(0.05f);
  points.emplace_back(0.5f, 0.5f, 30.0f);
  const DiscCloud discs = discs_of({.points = points, .normals = {}});
  EXPECT_FLOAT_EQ(*std::ranges::max_element(discs.radii), 4.0f * median_radius(discs));
}

TEST(DiscCloud, PointsThatRepeatOrAreNotFiniteAreDropped) {
  std::vector<Eigen::Vector3f> points = lattice(0.1f);
  points.insert(points.end(), 500, {0.0f, 0.0f, 0.0f});
  points.emplace_back(kNan, 1.0f, 1.0f);
  points.emplace_back(std::numeric_limits<float>::infinity(), 1.0f, 1.0f);
  const DiscCloud discs = discs_of({.points = points, .normals = {}});
  EXPECT_EQ(discs.size(), 121u);
  EXPECT_GT(*std::ranges::min_element(discs.radii), 0.05f);
}

TEST(DiscCloud, NormalsThatComeWithPointsAreKeptAndTheOthersFound) {
  PointCloud cloud{.points = lattice(0.1f), .normals = {}};
  cloud.normals.assign(cloud.points.size(), {2.0f, 0.0f, 0.0f});
  cloud.normals[0].setZero();
  cloud.normals[1].setConstant(kNan);
  const DiscCloud discs = discs_of(cloud);
  int found = 0;
  for (const Eigen::Vector3f& normal : discs.normals) {
    const bool kept = normal.isApprox(Eigen::Vector3f::UnitX());
    if (!kept) {
      EXPECT_NEAR(std::abs(normal.z()), 1.0f, 1e-5f);
    }
    found += kept ? 0 : 1;
  }
  EXPECT_EQ(found, 2);
}

TEST(DiscCloud, ThinningKeepsAPointACube) {
  const DiscCloud discs = discs_of({.points = lattice(0.02f), .normals = {}}, {.thinning = 0.1});
  EXPECT_NEAR(static_cast<double>(discs.size()), 121.0, 22.0);
  EXPECT_GT(median_radius(discs), 0.08f);
}

TEST(DiscCloud, DiscsBesideAnEdgeKeepToOneOfItsFaces) {
  const PointCloud cloud{.points = sample_surface({make_box({2, 2, 2})}, {.spacing = 0.05}).points, .normals = {}};
  const DiscCloud discs = discs_of(cloud);
  const auto along_an_axis =
      std::ranges::count_if(discs.normals, [](const Eigen::Vector3f& normal) { return normal.cwiseAbs().maxCoeff() > 0.99f; });
  EXPECT_GT(static_cast<double>(along_an_axis), 0.98 * static_cast<double>(discs.size()));
}

TEST(DiscCloud, TooFewPointsAndOptionsOutOfRangeAreRefused) {
  const PointCloud cloud{.points = lattice(0.1f), .normals = {}};
  EXPECT_THROW(discs_of({}), std::invalid_argument);
  EXPECT_THROW(discs_of({.points = {12, {1, 2, 3}}, .normals = {}}), std::invalid_argument);
  for (const DiscOptions& options : {DiscOptions{.thinning = 0.0},
                                     {.neighbours = 3, .spacing_neighbours = 2},
                                     {.overlap = 0.0},
                                     {.overlap = std::nan("")},
                                     {.spacing_neighbours = 13},
                                     {.most_spacings = 0.5}}) {
    EXPECT_THROW(discs_of(cloud, options), std::invalid_argument);
  }
}

TEST(DiscScene, RaysMeetADiscFromEitherSideAndPassBesideIt) {
  const Scene scene({}, {.centers = {{0, 0, 2}}, .normals = {{0, 0, 1}}, .radii = {0.5f}});
  const std::vector<Eigen::Vector3f> up{Eigen::Vector3f::UnitZ()}, down{-Eigen::Vector3f::UnitZ()};
  EXPECT_FLOAT_EQ(scene.cast({0.4f, 0, 0}, up, 10).front(), 2.0f);
  EXPECT_FLOAT_EQ(scene.cast({0.4f, 0, 5}, down, 10).front(), 3.0f);
  EXPECT_TRUE(std::isnan(scene.cast({0.6f, 0, 0}, up, 10).front()));
  EXPECT_TRUE(scene.bounds().isApprox(Eigen::AlignedBox3f(Eigen::Vector3f(-0.5f, -0.5f, 2), Eigen::Vector3f(0.5f, 0.5f, 2))));
}

TEST(DiscScene, APlaceNearADiscIsNotFree) {
  const Scene scene({test::moved(make_box({1, 1, 1}), 5, 0, 0)}, {.centers = {{0, 0, 2}}, .normals = {{0, 0, 1}}, .radii = {0.5f}});
  EXPECT_FALSE(scene.is_free({0.3f, 0, 2.05f}, 0.1f));
  EXPECT_TRUE(scene.is_free({0.3f, 0, 2.15f}, 0.1f));
  EXPECT_FALSE(scene.is_free({0.55f, 0, 2.0f}, 0.1f));
  EXPECT_TRUE(scene.is_free({0.65f, 0, 2.0f}, 0.1f));
  EXPECT_FALSE(scene.is_free({5, 0, 0}, 0.1f)) << "a mesh beside it still counts";
}

TEST(DiscScene, DiscsThatAreNotWholeOrNotFiniteAreRefused) {
  EXPECT_THROW(Scene({}, {.centers = {{0, 0, 2}}, .normals = {}, .radii = {0.5f}}), std::invalid_argument);
  EXPECT_THROW(Scene({}, {.centers = {{0, 0, kNan}}, .normals = {{0, 0, 1}}, .radii = {0.5f}}), std::invalid_argument);
  EXPECT_THROW(Scene({}, {.centers = {{0, 0, 2}}, .normals = {{0, 0, 1}}, .radii = {-0.5f}}), std::invalid_argument);
}

TriangleMesh inside_out(TriangleMesh mesh) {
  for (auto& [a, b, c] : mesh.triangles) std::swap(b, c);
  return mesh;
}

// A room of 8 × 6 × 3 m with a block in it: how far a scan of its sampled points is from one of itself.
TEST(DiscScene, AScanOfSampledSurfacesIsNearlyThatOfTheSurfaces) {
  const std::vector<TriangleMesh> room{inside_out(make_box({8, 6, 3})), test::moved(make_box({2, 1, 3}), 2, 1, 0)};
  const Scene truth(room);
  const Scene sampled({}, discs_of({.points = sample_surface(room, {.spacing = 0.05}).points, .normals = {}}));
  LidarModel lidar = test::small_lidar();
  lidar.elevations.clear();
  for (int i = 0; i < 20; ++i) lidar.elevations.push_back(-0.5 + 0.05 * i);
  lidar.sectors.front().columns = 360;
  const Eigen::Isometry3d pose(Eigen::Translation3d(-1.0, 0.3, 0.2));
  const Scan expected = simulate_scan(truth, lidar, pose), got = simulate_scan(sampled, lidar, pose);
  std::size_t missed = 0, off = 0;
  for (std::size_t i = 0; i < expected.points.size(); ++i) {
    const float difference = got.points[i].norm() - expected.points[i].norm();
    if (!(difference <= 0.1f)) {
      ++missed;
    } else if (std::abs(difference) > 0.02f) {
      ++off;
    }
  }
  EXPECT_LT(static_cast<double>(missed), 0.005 * static_cast<double>(expected.points.size()));
  EXPECT_LT(static_cast<double>(off), 0.02 * static_cast<double>(expected.points.size()));
}

TEST(SliceOfDiscs, PointsInTheBandAreSurfacesAndLevelDiscsBelowAreFloors) {
  std::vector<Eigen::Vector3f> points = lattice(0.1f);
  points.emplace_back(0.5f, 0.5f, 1.0f);
  points.emplace_back(0.5f, 0.5f, 3.0f);
  const Slice band = slice(discs_of({.points = points, .normals = {}}), 0.1, 2.0);
  ASSERT_EQ(band.surfaces.size(), 1u);
  EXPECT_EQ(band.surfaces[0], ConvexPolygon{Eigen::Vector2d(0.5, 0.5)});
  EXPECT_EQ(band.floors.size(), 121u);
  EXPECT_TRUE(band.solid_edges.empty());
  EXPECT_THROW(slice(DiscCloud{}, 2.0, 0.1), std::invalid_argument);
}

TEST(SliceOfDiscs, AWallIsNoFloor) {
  std::vector<Eigen::Vector3f> wall;
  for (const Eigen::Vector3f& point : lattice(0.1f)) wall.emplace_back(0.0f, point.x(), point.y() - 1.0f);
  EXPECT_TRUE(slice(discs_of({.points = wall, .normals = {}}), 0.1, 2.0).floors.empty());
}

}  // namespace
}  // namespace alignability
