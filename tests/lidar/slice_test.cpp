// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/slice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <utility>

#include "lidar/mesh_file.hpp"
#include "lidar/primitives.hpp"
#include "tests/lidar/fixtures.hpp"
#include "tests/shared_data.hpp"

namespace alignability {
namespace {

using test::moved;

double area(const ConvexPolygon& polygon) {
  double sum = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& a = polygon[i];
    const Eigen::Vector2d& b = polygon[(i + 1) % polygon.size()];
    sum += (a.x() * b.y() - a.y() * b.x()) / 2;
  }
  return sum;
}

double total_area(const std::vector<ConvexPolygon>& polygons) {
  double sum = 0.0;
  for (const ConvexPolygon& polygon : polygons) sum += area(polygon);
  return sum;
}

// By the crossings of a ray towards +x, each end of an edge counted once.
int winding_number(const Slice& slice, const Eigen::Vector2d& p) {
  int winding = 0;
  for (const auto& [a, b] : slice.solid_edges) {
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    const double x = a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    if (x > p.x()) winding += b.y() > a.y() ? 1 : -1;
  }
  return winding;
}

// The outlines are closed when as many edges end in every point as start from it.
bool edges_join(const Slice& slice) {
  std::map<std::pair<double, double>, int> balance;
  for (const auto& [from, to] : slice.solid_edges) {
    ++balance[{from.x(), from.y()}];
    --balance[{to.x(), to.y()}];
  }
  return std::ranges::all_of(balance, [](const auto& entry) { return entry.second == 0; });
}

TEST(Slice, ABoxThroughTheBandIsFourWallsAndAnOutline) {
  const Slice cut = slice({make_box({4, 2, 2})}, -0.5, 0.5);
  EXPECT_EQ(cut.surfaces.size(), 8u);
  for (const ConvexPolygon& wall : cut.surfaces) {
    ASSERT_EQ(wall.size(), 2u);
    // A tenth of a millimetre inside the faces.
    const Eigen::Vector2d middle = 0.5 * (wall[0] + wall[1]).cwiseAbs();
    EXPECT_NEAR(std::max(middle.x() - 2.0, middle.y() - 1.0), -1e-4, 1e-9);
  }
  EXPECT_TRUE(edges_join(cut));
  EXPECT_EQ(winding_number(cut, {0, 0}), 1);
  EXPECT_EQ(winding_number(cut, {2.1, 0}), 0);
  EXPECT_EQ(winding_number(cut, {0, -1.1}), 0);
  EXPECT_NEAR(total_area(cut.floors), 8.0, 1e-9);
}

TEST(Slice, WindingCountsNestedAndHollowSolids) {
  TriangleMesh cavity = make_box({2, 2, 2});
  for (auto& triangle : cavity.triangles) std::swap(triangle[0], triangle[1]);
  const Slice nested = slice({make_box({4, 4, 4}), make_box({2, 2, 2})}, -0.1, 0.1);
  EXPECT_EQ(winding_number(nested, {0, 0.01}), 2);
  EXPECT_EQ(winding_number(nested, {1.5, 0.01}), 1);
  const Slice hollow = slice({make_box({4, 4, 4}), cavity}, -0.1, 0.1);
  EXPECT_EQ(winding_number(hollow, {0, 0.01}), 0);
  EXPECT_EQ(winding_number(hollow, {1.5, 0.01}), 1);
}

TEST(Slice, VerticesInTheCuttingPlaneNeitherDoubleNorLoseEdges) {
  // Spheres have rings of vertices at z = 0, boxes faces at z = ±1; the cut runs through them.
  for (const double height : {-1.0, 0.0, 1.0}) {
    SCOPED_TRACE(height);
    const Slice cut = slice({make_sphere(2), moved(make_box({1, 1, 2}), 5, 0, 0)}, height - 0.25, height + 0.25);
    EXPECT_TRUE(edges_join(cut));
    EXPECT_EQ(winding_number(cut, {0.01, 0.02}), 1);
    EXPECT_EQ(winding_number(cut, {3.5, 0.02}), 0);
    EXPECT_EQ(winding_number(cut, {5.1, 0.02}), height < 1.0 ? 1 : 0);
  }
}

TEST(Slice, OutlinesOfTurnedShapesJoin) {
  std::mt19937_64 engine(3);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int i = 0; i < 50; ++i) {
    SCOPED_TRACE(i);
    const Eigen::Affine3d pose = Eigen::Translation3d(number(engine), number(engine), number(engine)) *
                                 Eigen::Quaterniond(number(engine), number(engine), number(engine), number(engine)).normalized();
    const Slice cut = slice({transformed(make_capsule(1, 2), pose)}, -0.1, 0.1);
    EXPECT_FALSE(cut.solid_edges.empty());
    EXPECT_TRUE(edges_join(cut));
    for (const ConvexPolygon& polygon : cut.surfaces) {
      ASSERT_GE(polygon.size(), 1u);
      EXPECT_GE(area(polygon), 0.0);
    }
  }
}

TEST(Slice, ClipsASlopeToTheBand) {
  // A ramp rising 1 m over 2 m of length: between 0.25 and 0.5 m it covers half a metre.
  TriangleMesh ramp{.name = "ramp", .vertices = {{0, 0, 0}, {2, 0, 1}, {2, 3, 1}, {0, 3, 0}}, .triangles = {{0, 1, 2}, {0, 2, 3}}};
  const Slice cut = slice({ramp}, 0.25, 0.5);
  EXPECT_NEAR(total_area(cut.surfaces), 0.5 * 3, 1e-6);
  EXPECT_NEAR(total_area(cut.floors), 0.5 * 3, 1e-6);
  EXPECT_TRUE(cut.solid_edges.empty());
}

TEST(Slice, SteepAndHighSurfacesAreNoFloor) {
  TriangleMesh steep{.name = "steep", .vertices = {{0, 0, -2}, {1, 0, 0}, {1, 3, 0}}, .triangles = {{0, 1, 2}}};
  const Slice cut = slice({steep, moved(make_rectangle(2, 2), 0, 0, 3)}, 0.1, 1);
  EXPECT_TRUE(cut.floors.empty());
  EXPECT_TRUE(cut.surfaces.empty());
}

TEST(Slice, AFloorThatFacesDownIsStillOne) {
  TriangleMesh floor = make_rectangle(2, 2);
  for (auto& triangle : floor.triangles) std::swap(triangle[0], triangle[1]);
  EXPECT_NEAR(total_area(slice({floor}, 0.1, 1).floors), 4.0, 1e-9);
}

TEST(Slice, NeedsFiniteHeightsInOrder) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  constexpr std::pair<double, double> kBands[] = {{kNan, 1.0}, {0.0, kNan}, {0.0, kInfinity}, {-kInfinity, 1.0}, {1.0, 1.0}, {2.0, 1.0}};
  for (const auto& [z_min, z_max] : kBands) {
    EXPECT_THROW(slice({make_box({4, 2, 2})}, z_min, z_max), std::invalid_argument) << z_min << ' ' << z_max;
  }
}

TEST(Slice, OfAnOfficeJoinsAndLeavesRoomsFree) {
  ALIGNABILITY_REQUIRE_SHARED_DATA(file, "meshes/office.dae");
  const Slice cut = slice(read_mesh_file(file), 0.1, 1.9);
  EXPECT_GT(cut.surfaces.size(), 100u);
  EXPECT_GT(cut.solid_edges.size(), 100u);
  EXPECT_TRUE(edges_join(cut));
  EXPECT_GT(total_area(cut.floors), 500.0);
}

}  // namespace
}  // namespace alignability
