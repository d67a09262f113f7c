// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/mesh_file.hpp"

#include <gtest/gtest.h>

#include "tests/lidar/fixtures.hpp"
#include "tests/shared_data.hpp"

namespace alignability {
namespace {

using test::fault_of;
using test::TemporaryFolder;

// A tetrahedron with corners at the origin and at 1, 2 and 3 units along x, y and z.
std::string collada(const std::string& asset) {
  return R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset>)" + asset +
         R"(</asset><library_geometries><geometry id="g" name="tetrahedron"><mesh>
<source id="p"><float_array id="pa" count="12">0 0 0 1 0 0 0 2 0 0 0 3</float_array><technique_common>
<accessor source="#pa" count="4" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor>
</technique_common></source><vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="4"><input semantic="VERTEX" source="#v" offset="0"/><p>0 2 1 0 1 3 0 3 2 1 2 3</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n" name="peak"><instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

constexpr const char* kCentimetresZUp = R"(<unit meter="0.01" name="centimeter"/><up_axis>Z_UP</up_axis>)";

Eigen::Vector3f extent(const std::vector<TriangleMesh>& meshes) { return bounds(merged(meshes, "")).sizes(); }

TEST(MeshFile, HonoursUnitAndUpAxisOfCollada) {
  const TemporaryFolder folder;
  EXPECT_TRUE(extent(read_mesh_file(folder.write("a.dae", collada(kCentimetresZUp)))).isApprox(Eigen::Vector3f(0.01f, 0.02f, 0.03f)));
  EXPECT_TRUE(extent(read_mesh_file(folder.write("b.dae", collada("<unit meter=\"1\"/><up_axis>Y_UP</up_axis>"))))
                  .isApprox(Eigen::Vector3f(1, 3, 2)));
  EXPECT_TRUE(extent(read_mesh_file(folder.write("c.dae", collada("<unit meter=\"1\"/><up_axis>X_UP</up_axis>"))))
                  .isApprox(Eigen::Vector3f(2, 3, 1)));
}

TEST(MeshFile, OptionsOverrideWhatTheFileSays) {
  const TemporaryFolder folder;
  const auto file = folder.write("a.dae", collada(kCentimetresZUp));
  EXPECT_TRUE(extent(read_mesh_file(file, {.unit = 2.0, .up_axis = {}, .submesh = {}})).isApprox(Eigen::Vector3f(2, 4, 6)));
  EXPECT_TRUE(
      extent(read_mesh_file(file, {.unit = {}, .up_axis = UpAxis::y, .submesh = {}})).isApprox(Eigen::Vector3f(0.01f, 0.03f, 0.02f)));
  const auto y_up = folder.write("b.dae", collada("<unit meter=\"1\"/><up_axis>Y_UP</up_axis>"));
  EXPECT_TRUE(extent(read_mesh_file(y_up, {.unit = {}, .up_axis = UpAxis::z, .submesh = {}})).isApprox(Eigen::Vector3f(1, 2, 3)));
}

TEST(MeshFile, UpAxesAreTurnedNotMirrored) {
  const TemporaryFolder folder;
  for (const char* axis : {"X_UP", "Y_UP", "Z_UP"}) {
    const auto file = folder.write("a.dae", collada("<up_axis>" + std::string(axis) + "</up_axis>"));
    EXPECT_NEAR(test::volume(read_mesh_file(file).front()), 1.0, 1e-6) << axis;
  }
  const auto file = folder.write("a.dae", collada(kCentimetresZUp));
  for (const UpAxis axis : {UpAxis::x, UpAxis::y, UpAxis::z}) {
    EXPECT_NEAR(test::volume(read_mesh_file(file, {.unit = 1.0, .up_axis = axis, .submesh = {}}).front()), 1.0, 1e-6);
  }
}

TEST(MeshFile, SubmeshIsANodeOrAGeometry) {
  const TemporaryFolder folder;
  const auto file = folder.write("a.dae", collada(kCentimetresZUp));
  const auto read = [&](const char* name) { return read_mesh_file(file, {.unit = {}, .up_axis = {}, .submesh = name}); };
  EXPECT_EQ(read("peak").front().triangles.size(), 4u);
  EXPECT_EQ(read("tetrahedron").front().triangles.size(), 4u);
  EXPECT_EQ(fault_of([&] { read("valley"); }), "a.dae: has no triangles named 'valley'");
}

TEST(MeshFile, ObjAndStlAreMetresZUp) {
  const TemporaryFolder folder;
  const auto obj = folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  const auto meshes = read_mesh_file(obj);
  EXPECT_TRUE(extent(meshes).isApprox(Eigen::Vector3f(1, 2, 3)));
  EXPECT_EQ(closed_part(meshes.front()).triangles.size(), 4u);
  const auto stl = folder.write(
      "A.STL", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 2 0\nendloop\nendfacet\nendsolid a\n");
  EXPECT_TRUE(extent(read_mesh_file(stl)).isApprox(Eigen::Vector3f(1, 2, 0)));
}

TEST(MeshFile, ReadsTheOffice) {
  ALIGNABILITY_REQUIRE_SHARED_DATA(file, "meshes/office.dae");
  const auto meshes = read_mesh_file(file);
  EXPECT_EQ(merged(meshes, "").triangles.size(), 3790u);
  EXPECT_TRUE(extent(meshes).isApprox(Eigen::Vector3f(44.0f, 25.4f, 2.51f), 0.01f));
}

TEST(MeshFile, ReadsTheObstacles) {
  ALIGNABILITY_REQUIRE_SHARED_DATA(file, "meshes/obstacle_world.stl");
  const auto meshes = read_mesh_file(file);
  EXPECT_EQ(merged(meshes, "").triangles.size(), 680u);
  EXPECT_TRUE(extent(meshes).isApprox(Eigen::Vector3f(12.3f, 8.3f, 2.6f), 0.01f));
}

}  // namespace
}  // namespace alignability
