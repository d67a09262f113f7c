// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "lidar/mesh_file.hpp"
#include "tests/lidar/fixtures.hpp"

namespace alignability {
namespace {

using test::fault_of;
using test::TemporaryFolder;

const std::string kDae = R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit meter="0.01"/>
<up_axis>Z_UP</up_axis></asset>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="pa" count="12">0 0 0 1 0 0 0 2 0 0 0 3</float_array><technique_common>
<accessor source="#pa" count="4" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor>
</technique_common></source><vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="4"><input semantic="VERTEX" source="#v" offset="0"/><p>0 2 1 0 1 3 0 3 2 1 2 3</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n"><instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)";

const std::string kPly =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
    "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 2 0\n3 0 1 2\n";
const std::string kObj = "v 0 0 0\nv 1 0 0\nv 0 2 0\nf 1 2 3\n";
const std::string kStl =
    "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 2 0\nendloop\nendfacet\nendsolid a\n";

std::string with(std::string text, const std::string& replaced, const std::string& by) {
  return text.replace(text.find(replaced), replaced.size(), by);
}

std::string binary_stl(const std::string& count, const std::string& triangles) { return std::string(80, ' ') + count + triangles; }

TEST(MeshErrors, TheFilesToBeDamagedAreGood) {
  const TemporaryFolder folder;
  EXPECT_EQ(merged(read_mesh_file(folder.write("a.dae", kDae)), "").triangles.size(), 4u);
  EXPECT_EQ(merged(read_mesh_file(folder.write("a.ply", kPly)), "").triangles.size(), 1u);
  EXPECT_EQ(merged(read_mesh_file(folder.write("a.obj", kObj)), "").triangles.size(), 1u);
  EXPECT_EQ(merged(read_mesh_file(folder.write("a.stl", kStl)), "").triangles.size(), 1u);
}

struct Malformed {
  const char* name;
  std::string bytes;
  std::string message;
};

class MalformedMesh : public testing::TestWithParam<Malformed> {};

TEST_P(MalformedMesh, IsRefusedAtItsPlace) {
  const TemporaryFolder folder;
  EXPECT_EQ(fault_of([&] { read_mesh_file(folder.write(GetParam().name, GetParam().bytes)); }), GetParam().name + GetParam().message);
}

const std::string kAsAMesh = ": cannot be read as a mesh: ";
const std::string kNotFinite = ": has a vertex that is not finite";
const std::string kNoTriangles = ": holds no triangles";

INSTANTIATE_TEST_SUITE_P(AnyKind, MalformedMesh,
                         testing::Values(Malformed{"a.txt", kObj, ": meshes are read from .dae, .stl, .obj, .ply, .gltf and .glb files"},
                                         Malformed{"a.gltf", R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[7]}],"scene":0})",
                                                   kAsAMesh + "GLTF: Missing section \"nodes\""}));

INSTANTIATE_TEST_SUITE_P(
    Collada, MalformedMesh,
    testing::Values(
        Malformed{"empty.dae", "", ":1:1: not valid XML: no element found"},
        Malformed{"a.dae", with(kDae, "</asset>", "</aset>"), ":4:26: not valid XML: mismatched tag"},
        Malformed{"a.dae", kDae.substr(0, kDae.find("<scene>")), ":11:1: not valid XML: no element found"},
        Malformed{"a.dae", "<?xml version=\"1.0\"?>\n<html/>", ":2:1: expected <COLLADA>, not <html>"},
        Malformed{"a.dae", with(kDae, "0.01", "0"), ":3:8: 'meter' must be greater than 0, not '0'"},
        Malformed{"a.dae", with(kDae, "0.01", "-1"), ":3:8: 'meter' must be greater than 0, not '-1'"},
        Malformed{"a.dae", with(kDae, "0.01", "cm"), ":3:8: 'meter' must be greater than 0, not 'cm'"},
        Malformed{"a.dae", with(kDae, "Z_UP", "z_up"), ":4:14: 'up_axis' is 'z_up', which is none of: X_UP, Y_UP, Z_UP"},
        Malformed{"a.dae", with(kDae, "count=\"12\"", "count=\"-12\""),
                  ":6:16: 'count' cannot be '-12' in a file of " + std::to_string(kDae.size() + 1) + " bytes"},
        Malformed{"a.dae", with(kDae, "count=\"12\"", "count=\"4000000000\""),
                  ":6:16: 'count' cannot be '4000000000' in a file of " + std::to_string(kDae.size() + 8) + " bytes"},
        Malformed{"a.dae", with(kDae, "url=\"#g\"", "url=\"#h\""), ":10:58: no <geometry> of this file is '#h'"},
        Malformed{"a.dae", with(kDae, "0 0 0 1", "0 0 0 nan"), kNotFinite},
        Malformed{"a.dae", with(kDae, "0 0 0 1 0 0", "0 0 0 1"), kAsAMesh + "Expected more values while reading float_array contents."},
        Malformed{"a.dae", with(kDae, "1 2 3</p>", "1 2 9</p>"), kAsAMesh + "Invalid data index (9/4) in primitive specification"},
        Malformed{"a.dae", with(kDae, "1 2 3</p>", "1 2</p>"), kAsAMesh + "Expected different index count in <p> element."},
        Malformed{"a.dae", with(kDae, "source=\"#p\"", "source=\"#q\""), kAsAMesh + "Unable to resolve library reference \"q\"."}));

INSTANTIATE_TEST_SUITE_P(
    Ply, MalformedMesh,
    testing::Values(Malformed{"a.ply", "", ":1: ends within the header"},
                    Malformed{"a.ply", "hello\n", ":1: a PLY file begins with a line 'ply'"},
                    Malformed{"a.ply", with(kPly, "ascii", "asci"), ":2: 'asci' is no format of a PLY file (did you mean 'ascii'?)"},
                    Malformed{"a.ply", with(kPly, "element vertex", "elment vertex"),
                              ":3: 'elment' is no keyword of a PLY header (did you mean 'element'?)"},
                    Malformed{"a.ply", with(kPly, "vertex 3", "vertex three"),
                              ":3: 'three' must be a whole number from 0 to " + std::to_string(kPly.size() + 4)},
                    Malformed{"a.ply", with(kPly, "face 1", "face 4000000000"),
                              ":7: '4000000000' must be a whole number from 0 to " + std::to_string(kPly.size() + 9)},
                    Malformed{"a.ply", with(kPly, "float y", "flaot y"), ":5: 'flaot' is no type of a PLY file (did you mean 'float'?)"},
                    Malformed{"a.ply", with(kPly, "float y", ""), ":5: 'property' is no complete line of a PLY header"},
                    Malformed{"a.ply", with(kPly, "end_header\n", ""), ":9: '0' is no keyword of a PLY header"},
                    Malformed{"a.ply", with(kPly, "3 0 1 2", "3 0 1 9"), ": has a face with vertex 9, counted from 0, of 3 vertices"},
                    Malformed{"a.ply", with(kPly, "3 0 1 2\n", ""), ": has a face without corners"},
                    Malformed{"a.ply", with(kPly, "1 0 0\n", "nan 0 0\n"), kNotFinite},
                    Malformed{"a.ply", with(with(kPly, "face 1", "face 0"), "3 0 1 2\n", ""), kNoTriangles}));

INSTANTIATE_TEST_SUITE_P(Obj, MalformedMesh,
                         testing::Values(Malformed{"a.obj", "nothing", kAsAMesh + "OBJ-file is too small."},
                                         Malformed{"a.obj", with(kObj, "f 1 2 3", "l 1 2"), kNoTriangles},
                                         Malformed{"a.obj", with(kObj, "f 1 2 3\n", "# none\n"), kNoTriangles},
                                         Malformed{"a.obj", with(kObj, "f 1 2 3", "f 1 2 9"), kAsAMesh + "OBJ: vertex index out of range"},
                                         Malformed{"a.obj", with(kObj, "f 1 2 3", "f 0 1 2"), kAsAMesh + "OBJ: Invalid face index."},
                                         Malformed{"a.obj", with(kObj, "0 2 0", "nan 2 0"), kNotFinite},
                                         Malformed{"a.obj", with(kObj, "0 2 0", "1e39 2 0"), kNotFinite}));

INSTANTIATE_TEST_SUITE_P(
    Stl, MalformedMesh,
    testing::Values(Malformed{"a.stl", "", kAsAMesh + "File is empty"}, Malformed{"a.stl", "solid a\nendsolid a\n", kNoTriangles},
                    Malformed{"a.stl", kStl.substr(0, kStl.find("vertex 0 2 0")), kAsAMesh + "STL: Invalid number of vertices"},
                    Malformed{"a.stl", "solidly built, but no STL", kNoTriangles},
                    Malformed{"a.stl", "no STL",
                              ": is neither a text STL, which begins with 'solid', nor a binary one, which has at least 84 bytes"},
                    Malformed{"a.stl", binary_stl("\xff\xff\xff\x7f", std::string(50, '\0')),
                              ": is 134 bytes long, where a binary STL of 2147483647 triangles has 107374182434"},
                    Malformed{"a.stl", binary_stl({"\1\0\0\0", 4}, std::string(49, '\0')),
                              ": is 133 bytes long, where a binary STL of 1 triangles has 134"},
                    Malformed{"a.stl", binary_stl({"\1\0\0\0", 4}, std::string(12, '\0') + std::string(36, '\xff') + std::string(2, '\0')),
                              kNotFinite}));

TEST(MeshErrors, AMissingFileOrSubmeshIsNamed) {
  const TemporaryFolder folder;
  EXPECT_EQ(fault_of([&] { read_mesh_file(folder / "missing.dae"); }), "missing.dae: no such file");
  std::filesystem::create_directory(folder / "folder.dae");
  EXPECT_EQ(fault_of([&] { read_mesh_file(folder / "folder.dae"); }), "folder.dae: not a regular file");
  const auto file = folder.write("a.dae", kDae);
  EXPECT_EQ(fault_of([&] { read_mesh_file(file, {.unit = {}, .up_axis = {}, .submesh = "lid"}); }), "a.dae: has no triangles named 'lid'");
}

TEST(MeshErrors, ACutFileIsRefused) {
  const TemporaryFolder folder;
  for (std::size_t length = 0; length < kDae.size(); length += 97) {
    EXPECT_NE(fault_of([&] { read_mesh_file(folder.write("a.dae", kDae.substr(0, length))); }), "") << length;
  }
  for (std::size_t length = 0; length < kPly.find("3 0 1 2"); ++length) {
    EXPECT_NE(fault_of([&] { read_mesh_file(folder.write("a.ply", kPly.substr(0, length))); }), "") << length;
  }
}

TEST(MeshErrors, DamageAnywhereIsAFaultOrAMeshWhoseTrianglesHaveCorners) {
  const TemporaryFolder folder;
  constexpr std::uint64_t kSeed = 47;
  SCOPED_TRACE(kSeed);
  std::mt19937_64 random(kSeed);
  const std::pair<const char*, std::string> files[] = {{"a.ply", kPly}, {"a.obj", kObj}, {"a.stl", kStl}};
  for (int i = 0; i < 1500; ++i) {
    const auto& [name, good] = files[random() % std::size(files)];
    std::string bytes = good;
    for (std::uint64_t k = 0; k <= random() % 3; ++k) bytes[random() % bytes.size()] = static_cast<char>(random());
    SCOPED_TRACE(testing::PrintToString(bytes));
    fault_of([&] {
      for (const TriangleMesh& mesh : read_mesh_file(folder.write(name, bytes))) {
        for (const auto& triangle : mesh.triangles) EXPECT_LT(*std::ranges::max_element(triangle), mesh.vertices.size());
      }
    });
  }
}

}  // namespace
}  // namespace alignability
