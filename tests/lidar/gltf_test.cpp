// SPDX-License-Identifier: BSD-3-Clause
// glTF 2.0, as text with its numbers in base 64 and as binary.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <random>

#include "lidar/mesh_file.hpp"
#include "tests/lidar/fixtures.hpp"

namespace alignability {
namespace {

using test::fault_of;
using test::TemporaryFolder;

// Twelve floats, the corners (0, 0, 0), (1, 0, 0), (0, 2, 0) and (0, 0, 3), then four triangles of two-byte indices.
constexpr const char* kNumbers = "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAAEAAAAAAAAAAAAAAAAAAAEBAAAACAAEAAAABAAMAAAADAAIAAQACAAMA";

// y is up by the standard.
std::string document(const std::string& buffer) {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"name":"peak"}],)"
         R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"buffers":[{"byteLength":72)" +
         buffer +
         R"(}],"bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":24}],)"
         R"("accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},)"
         R"({"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}]})";
}

const std::string kText = document(R"(,"uri":"data:application/octet-stream;base64,)" + std::string(kNumbers) + '"');

std::string word(std::uint32_t number) { return std::string(reinterpret_cast<const char*>(&number), sizeof number); }

std::string numbers() {
  const float corners[] = {0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 3};
  const std::uint16_t indices[] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  std::string bytes(sizeof corners + sizeof indices, '\0');
  std::memcpy(bytes.data(), corners, sizeof corners);
  std::memcpy(bytes.data() + sizeof corners, indices, sizeof indices);
  return bytes;
}

std::string binary() {
  std::string json = document("");
  json.resize((json.size() + 3) / 4 * 4, ' ');
  std::string chunks = word(static_cast<std::uint32_t>(json.size()));
  chunks.append("JSON").append(json).append(word(72)).append("BIN\0", 4).append(numbers());
  std::string file = "glTF";
  file.append(word(2)).append(word(static_cast<std::uint32_t>(12 + chunks.size()))).append(chunks);
  return file;
}

Eigen::Vector3f extent(const std::vector<TriangleMesh>& meshes) { return bounds(merged(meshes, "")).sizes(); }

TEST(Gltf, IsReadAsTextAndAsBinaryWithYUp) {
  const TemporaryFolder folder;
  for (const auto& file : {folder.write("a.gltf", kText), folder.write("a.glb", binary())}) {
    const auto meshes = read_mesh_file(file);
    ASSERT_EQ(meshes.size(), 1u);
    EXPECT_EQ(meshes[0].triangles.size(), 4u);
    EXPECT_TRUE(extent(meshes).isApprox(Eigen::Vector3f(1, 3, 2)));
    EXPECT_NEAR(test::volume(meshes[0]), 1.0, 1e-6);
  }
}

TEST(Gltf, UnitAndUpAxisMayBeGiven) {
  const TemporaryFolder folder;
  const auto meshes = read_mesh_file(folder.write("a.glb", binary()), {.unit = 0.1, .up_axis = UpAxis::z, .submesh = {}});
  EXPECT_TRUE(extent(meshes).isApprox(Eigen::Vector3f(0.1f, 0.2f, 0.3f)));
}

TEST(Gltf, NumbersMayStandInAFileBesideIt) {
  const TemporaryFolder folder;
  folder.write("numbers.bin", numbers());
  EXPECT_TRUE(extent(read_mesh_file(folder.write("a.gltf", document(R"(,"uri":"numbers.bin")")))).isApprox(Eigen::Vector3f(1, 3, 2)));
  EXPECT_THAT(fault_of([&] { read_mesh_file(folder.write("b.gltf", document(R"(,"uri":"missing.bin")"))); }),
              testing::HasSubstr("could not open referenced file \"missing.bin\""));
}

struct Malformed {
  const char* what;
  std::string replaced;
  std::string by;
  const char* message;
};

class MalformedGltf : public testing::TestWithParam<Malformed> {};

TEST_P(MalformedGltf, IsRefused) {
  const TemporaryFolder folder;
  std::string text = kText;
  ASSERT_NE(text.find(GetParam().replaced), std::string::npos);
  text.replace(text.find(GetParam().replaced), GetParam().replaced.size(), GetParam().by);
  EXPECT_THAT(fault_of([&] { read_mesh_file(folder.write("a.gltf", text)); }), testing::HasSubstr(GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(
    Table, MalformedGltf,
    testing::Values(
        Malformed{"HugeVertexCount", R"("count":4,)", R"("count":4000000000,)",
                  "Accessor with offset/length (0/16000000000) is out of range"},
        Malformed{"MoreVerticesThanBytes", R"("count":4,)", R"("count":40,)", "Accessor with offset/length (0/160) is out of range"},
        Malformed{"NegativeCount", R"("count":4,)", R"("count":-4,)", "Member \"count\" was not of type \"uint\""},
        Malformed{"NoVertices", R"("count":4,)", R"("count":0,)", "has no faces"},
        Malformed{"HugeIndexCount", R"("count":12)", R"("count":3000000000)", "Accessor with offset/length (0/6000000000) is out of range"},
        Malformed{"HugeBuffer", R"("byteLength":72)", R"("byteLength":7200000000)", "expected 7200000000 bytes, but found"},
        Malformed{"HugeView", R"("byteLength":48)", R"("byteLength":4800000000)",
                  "Buffer view with offset/length (0/4800000000) is out of range"},
        Malformed{"ViewBeyondItsBuffer", R"("byteOffset":48)", R"("byteOffset":70)",
                  "Buffer view with offset/length (70/24) is out of range"},
        Malformed{"MissingView", R"("bufferView":0)", R"("bufferView":9)", "Array index 9 is out of bounds (2) for \"bufferViews\""},
        Malformed{"MissingAccessor", R"("indices":1)", R"("indices":9)", "Array index 9 is out of bounds (2) for \"accessors\""},
        Malformed{"MissingMesh", R"("mesh":0)", R"("mesh":9)", "Array index 9 is out of bounds (1) for \"meshes\""},
        Malformed{"NodeInItself", R"("mesh":0)", R"("mesh":0,"children":[0])", "has recursive reference to itself"},
        Malformed{"PositionsInThePlane", "VEC3", "VEC2", "has positions that are not VEC3 of floats"},
        Malformed{"PositionsOfBytes", "5126", "5121", "has positions that are not VEC3 of floats"},
        Malformed{"IndicesOfFloats", "5123", "5126", "has indices that are not SCALAR of unsigned numbers"},
        Malformed{"Packed", R"("asset")", R"("extensionsRequired":["KHR_draco_mesh_compression"],"asset")",
                  "needs KHR_draco_mesh_compression, which is not read"},
        Malformed{"IndicesOfVectors", "SCALAR", "VEC2", "has indices that are not SCALAR of unsigned numbers"},
        Malformed{"PackedByAnother", R"("asset")", R"("extensionsRequired":["KHR_lights","KHR_mesh_quantization"],"asset")",
                  "needs KHR_mesh_quantization, which is not read"},
        Malformed{"MoreThanADoubleHolds", R"("count":12)", R"("count":1e999)", "has a number beyond what a double holds"},
        Malformed{"NotANumber", "AAAAAAAAAAAAAAAA", "AADAfwAAAAAAAAAA", "has a vertex that is not finite"},
        Malformed{"CutBase64", "BAAAACAAEA", "", "Invalid base64 encoded data"},
        Malformed{"NoBraceAtTheEnd", R"("SCALAR"}]})", R"("SCALAR"}])", "is no JSON from byte"},
        Malformed{"DeeplyNested", R"("asset")", "\"x\":" + std::string(100000, '[') + ",\"asset\"", "nested more than 64 deep"}),
    [](const auto& instance) { return instance.param.what; });

TEST(Gltf, ACutOrMislabelledBinaryIsRefused) {
  const TemporaryFolder folder;
  const auto fault = [&](const std::string& bytes) { return fault_of([&] { read_mesh_file(folder.write("a.glb", bytes)); }); };
  const std::string good = binary();
  for (std::size_t length = 0; length < good.size(); length += 13) EXPECT_NE(fault(good.substr(0, length)), "") << length;
  std::string bytes = good;
  EXPECT_EQ(fault(bytes.replace(4, 4, word(1))), "a.glb: is glTF of version 1, not 2");
  bytes = good;
  EXPECT_EQ(fault(bytes.replace(12, 4, word(0xffffffff))), "a.glb: ends within its first chunk");
  bytes = good;
  std::reverse(bytes.begin(), bytes.begin() + 4);
  EXPECT_NE(fault(bytes), "");
}

TEST(Gltf, DamageAnywhereIsAFaultOrAMeshWhoseTrianglesHaveCorners) {
  const TemporaryFolder folder;
  constexpr std::uint64_t kSeed = 53;
  SCOPED_TRACE(kSeed);
  std::mt19937_64 random(kSeed);
  for (int i = 0; i < 400; ++i) {
    const bool text = random() % 2 == 0;
    std::string bytes = text ? kText : binary();
    for (std::uint64_t k = 0; k <= random() % 3; ++k) bytes[random() % bytes.size()] = static_cast<char>(random());
    SCOPED_TRACE(testing::PrintToString(bytes));
    fault_of([&] {
      for (const TriangleMesh& mesh : read_mesh_file(folder.write(text ? "a.gltf" : "a.glb", bytes))) {
        for (const auto& triangle : mesh.triangles) EXPECT_LT(std::ranges::max(triangle), mesh.vertices.size());
      }
    });
  }
}

}  // namespace
}  // namespace alignability
