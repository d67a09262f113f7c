// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/mesh_bytes.hpp"

#include <cstdint>
#include <cstring>
#include <type_traits>

namespace alignability::detail {
namespace {

// A count, then so many values.
template <typename Values>
void put(std::string& bytes, const Values& values) {
  using Value = typename Values::value_type;
  const std::uint64_t count = values.size();
  bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
  bytes.append(reinterpret_cast<const char*>(values.data()), count * sizeof(Value));
}

template <typename Values>
Values take(std::string_view& bytes) {
  using Value = typename Values::value_type;
  std::uint64_t count = 0;
  std::memcpy(&count, bytes.data(), sizeof count);
  bytes.remove_prefix(sizeof count);
  Values values;
  values.resize(count);
  std::memcpy(static_cast<void*>(values.data()), bytes.data(), count * sizeof(Value));
  bytes.remove_prefix(count * sizeof(Value));
  return values;
}

}  // namespace

std::string bytes_of(const std::vector<TriangleMesh>& meshes) {
  std::string bytes;
  for (const TriangleMesh& mesh : meshes) {
    put(bytes, mesh.name);
    put(bytes, mesh.vertices);
    put(bytes, mesh.triangles);
  }
  return bytes;
}

std::vector<TriangleMesh> meshes_of(std::string_view bytes) {
  std::vector<TriangleMesh> meshes;
  while (!bytes.empty()) {
    TriangleMesh& mesh = meshes.emplace_back();
    mesh.name = take<std::string>(bytes);
    mesh.vertices = take<std::vector<Eigen::Vector3f>>(bytes);
    mesh.triangles = take<std::vector<std::array<std::uint32_t, 3>>>(bytes);
  }
  return meshes;
}

}  // namespace alignability::detail
