// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/triangle_mesh.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "lidar/primitives.hpp"
#include "tests/lidar/fixtures.hpp"

namespace alignability {
namespace {

using test::moved;
using test::volume;

TEST(Primitives, EncloseTheirVolumeFacingOutwards) {
  constexpr double kPi = std::numbers::pi;
  EXPECT_NEAR(volume(make_box({1, 2, 3})), 6.0, 1e-5);
  EXPECT_NEAR(volume(make_cylinder(0.5, 2)) / (kPi * 0.5), 1.0, 0.005);
  EXPECT_NEAR(volume(make_sphere(2)) / (4.0 / 3.0 * kPi * 8.0), 1.0, 0.01);
  EXPECT_NEAR(volume(make_ellipsoid({1, 2, 3})) / (4.0 / 3.0 * kPi * 6.0), 1.0, 0.01);
  EXPECT_NEAR(volume(make_capsule(1, 3)) / (kPi * 3 + 4.0 / 3.0 * kPi), 1.0, 0.01);
}

TEST(Primitives, AreClosedAllButTheRectangle) {
  for (const TriangleMesh& mesh :
       {make_box({1, 2, 3}), make_cylinder(0.5, 2), make_sphere(2), make_ellipsoid({1, 2, 3}), make_capsule(1, 3)}) {
    EXPECT_EQ(closed_part(mesh).triangles.size(), mesh.triangles.size()) << mesh.name;
  }
  EXPECT_TRUE(closed_part(make_rectangle(1, 2)).triangles.empty());
}

TEST(Primitives, ReachTheirExtents) {
  EXPECT_TRUE(bounds(make_capsule(1, 3)).isApprox(Eigen::AlignedBox3f(Eigen::Vector3f(-1, -1, -2.5f), Eigen::Vector3f(1, 1, 2.5f)), 1e-5f));
  EXPECT_TRUE(bounds(make_sphere(2)).isApprox(Eigen::AlignedBox3f(Eigen::Vector3f(-2, -2, -2), Eigen::Vector3f(2, 2, 2)), 1e-5f));
}

TEST(TriangleMesh, AMirrorLeavesTheOutsideOutside) {
  Eigen::Affine3d mirror(Eigen::Scaling(Eigen::Vector3d(-2, 1, 1)));
  EXPECT_NEAR(volume(transformed(make_box({1, 1, 1}), mirror)), 2.0, 1e-6);
  mirror = Eigen::Scaling(Eigen::Vector3d(-1, -1, 1));
  EXPECT_NEAR(volume(transformed(make_box({1, 1, 1}), mirror)), 1.0, 1e-6);
}

TEST(ClosedPart, WeldsVerticesThatAreWrittenOncePerTriangle) {
  const TriangleMesh box = make_box({1, 1, 1});
  TriangleMesh soup;
  for (const auto& triangle : box.triangles) {
    for (const std::uint32_t vertex : triangle) soup.vertices.push_back(box.vertices[vertex]);
    const auto first = static_cast<std::uint32_t>(soup.vertices.size()) - 3;
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  const TriangleMesh closed = closed_part(soup);
  EXPECT_EQ(closed.triangles.size(), 12u);
  EXPECT_EQ(closed.vertices.size(), 8u);
}

TEST(ClosedPart, LeavesOutWhatHasAHole) {
  TriangleMesh box = make_box({1, 1, 1});
  box.triangles.pop_back();
  EXPECT_TRUE(closed_part(box).triangles.empty());
}

TEST(ClosedPart, TellsComponentsApartEvenWhereTheyTouchInACorner) {
  TriangleMesh open = moved(make_box({1, 1, 1}), 1, 1, 1);
  open.triangles.pop_back();
  const std::array parts{make_box({1, 1, 1}), open, moved(make_box({1, 1, 1}), 5, 0, 0)};
  EXPECT_EQ(closed_part(merged(parts, "all")).triangles.size(), 24u);
}

TEST(ClosedPart, DropsTrianglesWithoutArea) {
  TriangleMesh box = make_box({1, 1, 1});
  box.triangles.push_back({0, 0, 1});
  EXPECT_EQ(closed_part(box).triangles.size(), 12u);
}

TEST(ClosedPart, RefusesFacesThatLookBothWays) {
  TriangleMesh box = make_box({1, 1, 1});
  std::swap(box.triangles[3][0], box.triangles[3][1]);
  EXPECT_TRUE(closed_part(box).triangles.empty());
}

}  // namespace
}  // namespace alignability
