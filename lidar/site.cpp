// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/site.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <stdexcept>
#include <string_view>

#include "core/input_error.hpp"
#include "lidar/floor_plane.hpp"
#include "lidar/scan_file.hpp"

namespace alignability {
namespace {

namespace fs = std::filesystem;

enum class Kind { world, mesh, cloud };

// Enough for the header of a PLY and the root of a COLLADA file.
constexpr std::size_t kHead = std::size_t{1} << 16;
constexpr float kFarthest = 1e5f;

std::string head_of(const fs::path& file) {
  std::error_code error;
  if (!fs::exists(file, error)) throw InputError(file, "no such file");
  if (!fs::is_regular_file(file, error)) throw InputError(file, "not a regular file");
  std::ifstream stream(file, std::ios::binary);
  std::string head(kHead, '\0');
  stream.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(std::max<std::streamsize>(stream.gcount(), 0)));
  return head;
}

bool has_extension_of_worlds(const fs::path& file) {
  const std::string extension = file.extension().string();
  return extension == ".sdf" || extension == ".world";
}

Kind kind_of(const fs::path& file) {
  const std::string bytes = head_of(file);
  const std::string_view head = bytes;
  const std::string_view text = head.substr(std::min(head.find_first_not_of(" \t\r\n"), head.size()));
  if (text.starts_with("ply") && is_mesh_file(file) && !is_cloud_file(head, file)) return Kind::mesh;
  if (head.starts_with("glTF") || text.starts_with('{')) return Kind::mesh;
  if (text.starts_with('<')) return head.find("<COLLADA") == std::string_view::npos ? Kind::world : Kind::mesh;
  if (is_cloud_file(head, file)) return Kind::cloud;
  if (is_mesh_file(file)) return Kind::mesh;
  if (has_extension_of_worlds(file)) return Kind::world;
  throw InputError(file, "is no site that is known: a world (SDF), a mesh (DAE, STL, OBJ, PLY, glTF) or a point cloud (PCD, PLY, BIN)");
}

void refuse_options_of_others(Kind kind, const fs::path& file, const SiteOptions& options) {
  if (kind == Kind::world && (options.unit || options.up_axis)) {
    throw InputError(file, "is a world, whose unit and up axis SDF lays down: --unit and --up are for meshes and point clouds");
  }
  if (kind != Kind::cloud && options.discs.thinning) throw InputError(file, "is no point cloud, and --thin is for these");
  if (kind != Kind::cloud && options.level) throw InputError(file, "is no point cloud, and --level is for these");
}

PointCloud in_map(PointCloud cloud, const fs::path& file, const SiteOptions& options) {
  const Eigen::Matrix3f turn = to_z_up(options.up_axis.value_or(UpAxis::z)).cast<float>();
  const auto scale = static_cast<float>(options.unit.value_or(1.0));
  for (Eigen::Vector3f& point : cloud.points) {
    point = scale * (turn * point);
    if (point.array().abs().maxCoeff() <= kFarthest || !point.allFinite()) continue;
    throw InputError(file,
                     "has points farther than 100 km from its origin, where single precision blurs them: move it near, or give --unit");
  }
  for (Eigen::Vector3f& normal : cloud.normals) normal = turn * normal;
  return cloud;
}

Site read_cloud(const fs::path& file, const SiteOptions& options) {
  PointCloud cloud = in_map(read_cloud_file(file), file, options);
  Site site;
  try {
    if (options.level) site.T_map_file = leveled(cloud.points);
    const Eigen::Isometry3f T_map_file = site.T_map_file.cast<float>();
    for (Eigen::Vector3f& point : cloud.points) point = T_map_file * point;
    for (Eigen::Vector3f& normal : cloud.normals) normal = T_map_file.linear() * normal;
    site.discs = discs_of(cloud, options.discs);
  } catch (const std::invalid_argument& error) {
    throw InputError(file, error.what());
  }
  return site;
}

}  // namespace

Site read_site(const fs::path& file, const SiteOptions& options) {
  const Kind kind = kind_of(file);
  refuse_options_of_others(kind, file, options);
  if (kind == Kind::cloud) return read_cloud(file, options);
  if (kind == Kind::mesh) {
    const MeshOptions mesh{.unit = options.unit, .up_axis = options.up_axis, .submesh = {}};
    return {.meshes = read_mesh_file(file, mesh)};
  }
  World world = read_world(file, options.world);
  return {.meshes = std::move(world.meshes), .warnings = std::move(world.warnings)};
}

}  // namespace alignability
