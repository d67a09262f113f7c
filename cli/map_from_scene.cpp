// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <chrono>
#include <iostream>
#include <utility>

#include "alignability/map_update.hpp"
#include "cli/exit_code.hpp"
#include "cli/interrupt.hpp"
#include "cli/map_builds.hpp"
#include "cli/map_output.hpp"
#include "cli/output_name.hpp"
#include "cli/progress_bar.hpp"
#include "cli/scene_options.hpp"
#include "core/input_error.hpp"
#include "costmap/map_server.hpp"

namespace alignability::cli {
namespace {

std::string provenance(const MapCommandOptions& options) {
  const std::string update = options.update ? "\nupdate_of: " + options.update->filename().string() : "";
  return "scene: " + options.scene.filename().string() + "\noccupancy: " + options.occupancy->filename().string() +
         "\nsensor: " + options.sensor->filename().string() + update + "\nmade_by: alignability " ALIGNABILITY_VERSION "\n";
}

// Says once how much of the map was there already.
ProgressCallback telling_of_the_start(ProgressCallback show, const std::filesystem::path& checkpoint) {
  return [show = std::move(show), checkpoint, started = false](Progress progress) mutable {
    if (!std::exchange(started, true) && progress.done > 0) {
      std::cerr << checkpoint.string() << ": " << progress.done << " of " << progress.total << " cells are there; going on from them\n";
    }
    show(progress);
  };
}

// Where what is done is kept until the map is stored. A part's is another's than the whole's, which it would remove at its end.
std::filesystem::path checkpoint_of(const MapCommandOptions& options) {
  const bool whole = options.cells.empty() && options.polygon.empty();
  return with_ending(output_name(options.output), whole ? ".part" : ".cells.part");
}

AlignabilityMap build(const Scene& scene, const OccupancyMap& occupancy, const SensorRig& sensor, MapOptions options) {
  ProgressBar bar("alignability map");
  options.progress = telling_of_the_start(bar.callback(), *options.checkpoint);
  return build_alignability_map(scene, occupancy, sensor, options);
}

// A sensor that does not see all around sees another thing at every heading.
int headings_of(const MapCommandOptions& options, const SensorRig& sensor) {
  constexpr int kUsual = 8;
  return options.headings.value_or(sensor.sees_all_around() ? 1 : kUsual);
}

void check_choice(const MapCommandOptions& options) {
  if (options.cells.size() % 2 != 0) throw std::invalid_argument("--cells: takes pairs of column,row");
  if (options.polygon.size() % 2 != 0) throw std::invalid_argument("--polygon: takes pairs of x,y");
  if (options.update && options.cells.empty() && options.polygon.empty()) {
    throw std::invalid_argument("--update takes --cells or --polygon: what to build anew");
  }
}

// Those that are to be built, where not all are.
std::optional<std::vector<Cell>> chosen_cells(const MapCommandOptions& options, const GridGeometry& occupancy) {
  if (options.cells.empty() && options.polygon.empty()) return std::nullopt;
  const GridGeometry geometry = alignability_geometry(occupancy, options.map.resolution);
  std::vector<Eigen::Vector2d> corners;
  for (std::size_t i = 0; i < options.polygon.size(); i += 2) corners.emplace_back(options.polygon[i], options.polygon[i + 1]);
  std::vector<Cell> cells;
  if (!corners.empty()) cells = cells_meeting(geometry, corners);
  for (std::size_t i = 0; i < options.cells.size(); i += 2) cells.push_back({options.cells[i], options.cells[i + 1]});
  if (cells.empty()) throw std::invalid_argument("--polygon meets no cell of the map");
  const auto order = [&](Cell cell) { return std::pair(cell.y, cell.x); };
  std::ranges::sort(cells, {}, order);
  cells.erase(std::ranges::unique(cells).begin(), cells.end());
  return cells;
}

// At the start rather than at the end.
void refuse_unless_alike(const std::filesystem::path& file, const AlignabilityMap& before, const Scene& scene,
                         const OccupancyMap& occupancy, const SensorRig& sensor, MapOptions options) {
  options.checkpoint.reset();
  options.cells.emplace();
  try {
    updated(before, build_alignability_map(scene, occupancy, sensor, options), *options.cells);
  } catch (const std::invalid_argument& error) {
    throw InputError(file, error.what());
  }
}

int build_and_store(MapCommandOptions options) {
  check_choice(options);
  const Interrupt interrupt;
  const auto begin = std::chrono::steady_clock::now();
  const SensorRig sensor = read_sensor_rig(*options.sensor);
  const OccupancyMap occupancy = read_occupancy_map(*options.occupancy);
  const Scene scene = read_scene(options.scene, options.reading);
  options.map.headings = headings_of(options, sensor);
  options.map.alignability = for_lidar(options.map.alignability, sensor);
  options.map.cells = chosen_cells(options, occupancy.geometry());
  const auto before = options.update ? std::optional(read_alignability_map(*options.update)) : std::nullopt;
  options.map.stop = interrupt.token();
  if (before) refuse_unless_alike(*options.update, *before, scene, occupancy, sensor, options.map);
  const std::filesystem::path name = output_name(options.output);
  options.map.checkpoint = checkpoint_of(options);
  AlignabilityMap built = build(scene, occupancy, sensor, options.map);
  built.provenance = provenance(options);
  store_map(before ? updated(*before, built, *options.map.cells) : built, occupancy, name, options.pictures);
  std::filesystem::remove(*options.map.checkpoint);
  tell(map_json(built, seconds_since(begin), map_files(name, options.pictures)), options.json);
  return kYes;
}

}  // namespace

int map_from_scene(const MapCommandOptions& options) {
  try {
    return build_and_store(options);
  } catch (const Interrupted&) {
    std::cerr << "\nalignability: interrupted; " << checkpoint_of(options).string()
              << " keeps what is done, and the same command goes on from there\n";
    return kInterrupted;
  }
}

}  // namespace alignability::cli
