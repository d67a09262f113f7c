// SPDX-License-Identifier: BSD-3-Clause
#include "tests/fuzz/readers.hpp"

#include <unistd.h>

#include <array>
#include <cstdio>

#include "alignability/sites_file.hpp"
#include "core/file.hpp"
#include "core/input_error.hpp"
#include "costmap/alignability_map.hpp"
#include "costmap/float_tiff.hpp"
#include "costmap/grey_image.hpp"
#include "costmap/map_server.hpp"
#include "costmap/raster_file.hpp"
#include "lidar/carmen_log.hpp"
#include "lidar/mesh_file.hpp"
#include "lidar/mesh_import.hpp"
#include "lidar/ply_file.hpp"
#include "lidar/scan_file.hpp"
#include "lidar/sdf_world.hpp"
#include "lidar/sensor_rig.hpp"
#include "lidar/trajectory.hpp"
#include "localization/drive_file.hpp"
#include "planner/plan_problem.hpp"
#include "planner/route_file.hpp"
#include "planner/station_file.hpp"

namespace alignability::test {
namespace {

using Path = std::filesystem::path;

void write(const Path& file, std::string_view bytes) {
  // Plain, for it is done a million times.
  std::FILE* out = std::fopen(file.c_str(), "wb");
  if (out == nullptr || std::fwrite(bytes.data(), 1, bytes.size(), out) != bytes.size() || std::fclose(out) != 0) std::abort();
}

const GridGeometry kThreeByTwo{.resolution = 0.5, .origin = Eigen::Vector2d::Zero(), .width = 3, .height = 2};

void put_image(const Path& folder) { write(folder / "image.pgm", "P5 3 2 255\n\xfe\x01\xcd\xfe\xfe\x80"); }

void put_map(const Path& folder) {
  write(folder / "map.yaml", "image: file.pgm\nresolution: 0.5\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.25\n");
}

void put_layers(const Path& folder) {
  const AlignabilityMap::Layer alpha{"alpha", Grid<float>(kThreeByTwo, 0.5f)};
  detail::write_float_tiff(folder / "image.tiff", {&alpha, 1});
}

constexpr std::array kReaders{
    FuzzedReader{"map_server", ".yaml", [](const Path& file) { read_occupancy_map(file); }, put_image},
    FuzzedReader{"map_image", ".pgm", [](const Path& file) { read_occupancy_map(file.parent_path() / "map.yaml"); }, put_map},
    FuzzedReader{"pnm", ".pgm", [](const Path& file) { detail::read_grey_image(file); }},
    FuzzedReader{"png", ".png", [](const Path& file) { detail::read_grey_image(file); }},
    FuzzedReader{"tiff", ".tiff", [](const Path& file) { detail::read_float_tiff(file, kThreeByTwo, 4); }},
    FuzzedReader{"raster", ".tiff", [](const Path& file) { read_raster({.file = file, .place = RasterPlace{.resolution = 1.0}}); }},
    FuzzedReader{"alignability_map", ".yaml", [](const Path& file) { read_alignability_map(file); }, put_layers},
    FuzzedReader{"pcd", ".pcd", [](const Path& file) { read_scan_file(file); }},
    FuzzedReader{"ply", ".ply", [](const Path& file) { read_cloud_file(file); }},
    FuzzedReader{"bin", ".bin", [](const Path& file) { read_scan_file(file); }},
    FuzzedReader{"stl", ".stl", [](const Path& file) { read_mesh_file(file); }},
    FuzzedReader{"obj", ".obj", [](const Path& file) { read_mesh_file(file); }},
    FuzzedReader{"ply_mesh", ".ply", [](const Path& file) { read_mesh_file(file); }},
    FuzzedReader{"collada", ".dae", [](const Path& file) { read_mesh_file(file); }},
    FuzzedReader{"gltf", ".gltf", [](const Path& file) { read_mesh_file(file); }},
    // What happens in a child process, and before it, in this one: some hundred times as fast.
    FuzzedReader{"stl_import", ".stl", [](const Path& file) { detail::import_meshes(file, {}); }},
    FuzzedReader{"obj_import", ".obj", [](const Path& file) { detail::import_meshes(file, {}); }},
    FuzzedReader{"ply_header", ".ply", [](const Path& file) { detail::check_ply_header(read_file(file, 1 << 24), file); }},
    FuzzedReader{"sdf", ".sdf", [](const Path& file) { read_world(file); }},
    FuzzedReader{"sensor", ".yaml", [](const Path& file) { read_sensor_rig(file); }},
    FuzzedReader{"problem", ".yaml", [](const Path& file) { read_problem_file(file); }},
    FuzzedReader{"drive", ".yaml", [](const Path& file) { read_drive_file(file); }},
    FuzzedReader{"stations", ".yaml", [](const Path& file) { read_station_file(file); }},
    FuzzedReader{"sites", ".yaml", [](const Path& file) { read_sites_file(file); }},
    FuzzedReader{"trajectory", ".txt", [](const Path& file) { read_trajectory(file); }},
    FuzzedReader{"carmen", ".log", [](const Path& file) { read_carmen_log(file); }},
    FuzzedReader{"geojson", ".geojson", [](const Path& file) { read_route(file, {}); }},
    FuzzedReader{"lif", ".json", [](const Path& file) { read_route(file, {}); }},
    FuzzedReader{"path", ".csv", [](const Path& file) { read_route(file, {}); }},
};

// Where writing costs no disk.
Path fast_folder() { return std::filesystem::is_directory("/dev/shm") ? "/dev/shm" : std::filesystem::temp_directory_path(); }

}  // namespace

std::span<const FuzzedReader> fuzzed_readers() { return kReaders; }

FuzzedFile::FuzzedFile(const FuzzedReader& reader)
    : reader_(reader), folder_(fast_folder() / ("alignability-fuzz-" + std::to_string(::getpid()) + '-' + reader.name)) {
  std::filesystem::create_directories(folder_);
  file_ = folder_ / (std::string("file") + reader.extension);
  reader.prepare(folder_);
}

FuzzedFile::~FuzzedFile() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

bool FuzzedFile::read(std::string_view bytes) const {
  write(file_, bytes);
  try {
    reader_.read(file_);
  } catch (const InputError&) {
    return false;
  }
  return true;
}

}  // namespace alignability::test
