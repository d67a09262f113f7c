// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/mesh_file.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "core/file.hpp"
#include "core/input_error.hpp"
#include "lidar/child_process.hpp"
#include "lidar/collada_check.hpp"
#include "lidar/gltf_check.hpp"
#include "lidar/mesh_bytes.hpp"
#include "lidar/mesh_import.hpp"
#include "lidar/ply_file.hpp"

namespace alignability {
namespace {

constexpr std::uintmax_t kLargestFile = std::uintmax_t{1} << 30;
// A text begins with "solid"; else there are 80 bytes of anything, the number of triangles and 50 bytes for each.
void check_stl(std::string_view bytes, const std::filesystem::path& file) {
  constexpr std::size_t kHead = 84;
  if (bytes.empty() || bytes.substr(std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size())).starts_with("solid")) return;
  if (bytes.size() < kHead) {
    throw InputError(file, "is neither a text STL, which begins with 'solid', nor a binary one, which has at least 84 bytes");
  }
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + kHead - sizeof count, sizeof count);
  const std::uint64_t expected = kHead + 50 * std::uint64_t{count};
  if (bytes.size() == expected) return;
  throw InputError(file, "is " + std::to_string(bytes.size()) + " bytes long, where a binary STL of " + std::to_string(count) +
                             " triangles has " + std::to_string(expected));
}

void check_file(const std::filesystem::path& file) {
  std::error_code error;
  if (!is_mesh_file(file)) throw InputError(file, "meshes are read from .dae, .stl, .obj, .ply, .gltf and .glb files");
  if (!std::filesystem::exists(file, error)) throw InputError(file, "no such file");
  if (!std::filesystem::is_regular_file(file, error)) throw InputError(file, "not a regular file");
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error) throw InputError(file, "cannot be read: " + error.message());
  if (size > kLargestFile)
    throw InputError(file, "is " + std::to_string(size) + " bytes long; at most " + std::to_string(kLargestFile) + " are read");
  // The importer allocates what these promise.
  const std::string extension = detail::lower_extension(file);
  if (extension == ".ply") detail::check_ply_header(read_file(file, kLargestFile), file);
  if (extension == ".dae") detail::check_collada(read_file(file, kLargestFile), file);
  if (extension == ".gltf" || extension == ".glb") detail::check_gltf(read_file(file, kLargestFile), file);
  if (extension == ".stl") check_stl(read_file(file, kLargestFile), file);
}

// The importer reads some MiB a second, into some tens of bytes a byte.
detail::ChildLimits limits_of(std::uintmax_t size) {
  return {.time = std::chrono::seconds(5 + 2 * static_cast<std::int64_t>(size >> 20)), .memory = (std::uintmax_t{1} << 30) + 64 * size};
}

// In a process of its own, which may crash.
std::vector<TriangleMesh> import_apart(const std::filesystem::path& file, const MeshOptions& options) {
  const auto import = [&]() -> std::string {
    try {
      return 'M' + detail::bytes_of(detail::import_meshes(file, options));
    } catch (const InputError& error) {
      return 'E' + std::string(error.what());
    }
  };
  const detail::ChildOutcome outcome = detail::in_child_process(import, limits_of(std::filesystem::file_size(file)));
  if (!outcome.fault.empty()) throw InputError(file, "cannot be read as a mesh: assimp, which reads it, " + outcome.fault);
  const std::string_view bytes = std::string_view(outcome.bytes).substr(1);
  if (outcome.bytes.front() == 'M') return detail::meshes_of(bytes);
  const std::string place = file.string() + ": ";
  throw InputError(file, bytes.starts_with(place) ? bytes.substr(place.size()) : bytes);
}

}  // namespace

// COLLADA 1.4.1, up_axis: what points right, up and towards the viewer.
Eigen::Matrix3d to_z_up(UpAxis up) {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  if (up == UpAxis::x) rotation << 0, -1, 0, 0, 0, -1, 1, 0, 0;
  if (up == UpAxis::y) rotation << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  return rotation;
}

bool is_mesh_file(const std::filesystem::path& file) {
  static constexpr std::array kExtensions{".dae", ".stl", ".obj", ".ply", ".gltf", ".glb"};
  return std::ranges::find(kExtensions, detail::lower_extension(file)) != kExtensions.end();
}

std::vector<TriangleMesh> read_mesh_file(const std::filesystem::path& file, const MeshOptions& options) {
  check_file(file);
  std::vector<TriangleMesh> meshes = import_apart(file, options);
  if (meshes.empty() && options.submesh) throw InputError(file, "has no triangles named '" + *options.submesh + "'");
  if (meshes.empty()) throw InputError(file, "holds no triangles");
  return meshes;
}

}  // namespace alignability
