// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <utility>

#include "alignability/build_map.hpp"
#include "alignability/map_update.hpp"
#include "cli/command.hpp"
#include "cli/interrupt.hpp"
#include "cli/json.hpp"
#include "cli/output_name.hpp"
#include "cli/progress_bar.hpp"
#include "cli/scene_options.hpp"
#include "cli/scoring_options.hpp"
#include "core/input_error.hpp"
#include "costmap/map_server.hpp"
#include "pictures/alignability_picture.hpp"

namespace alignability::cli {
namespace {

struct Options {
  std::filesystem::path scene;
  WorldOptions reading;
  std::filesystem::path occupancy;
  std::filesystem::path sensor;
  MapOptions map;
  std::vector<int> cells;
  std::vector<double> polygon;
  std::optional<std::filesystem::path> update;
  bool json = false;
  std::filesystem::path output;
};

std::string provenance(const Options& options) {
  const std::string update = options.update ? "\nupdate_of: " + options.update->filename().string() : "";
  return "scene: " + options.scene.filename().string() + "\noccupancy: " + options.occupancy.filename().string() +
         "\nsensor: " + options.sensor.filename().string() + update + "\nmade_by: alignability " ALIGNABILITY_VERSION "\n";
}

void print_summary(const Json& summary) {
  const Json& alpha = summary["alpha"];
  const double seconds = summary["seconds"];
  std::cout << summary["cells_evaluated"] << " of " << summary["cells"] << " cells from " << summary["scans"] << " scans in "
            << duration_text(seconds) << '\n';
  if (!alpha["min"].is_null()) {
    std::printf("alpha: min %.3f, median %.3f, max %.3f\n", alpha["min"].get<double>(), alpha["median"].get<double>(),
                alpha["max"].get<double>());
    std::fflush(stdout);
  }
  for (const Json& file : summary["files"]) std::cout << "wrote " << file.get<std::string>() << '\n';
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
std::filesystem::path checkpoint_of(const Options& options) {
  const bool whole = options.cells.empty() && options.polygon.empty();
  return with_ending(output_name(options.output), whole ? ".part" : ".cells.part");
}

AlignabilityMap build(const Scene& scene, const OccupancyMap& occupancy, const LidarModel& lidar, MapOptions options) {
  ProgressBar bar("alignability map");
  options.progress = telling_of_the_start(bar.callback(), *options.checkpoint);
  return build_alignability_map(scene, occupancy, lidar, options);
}

void check_choice(const Options& options) {
  if (options.cells.size() % 2 != 0) throw std::invalid_argument("--cells: takes pairs of column,row");
  if (options.polygon.size() % 2 != 0) throw std::invalid_argument("--polygon: takes pairs of x,y");
  if (options.update && options.cells.empty() && options.polygon.empty()) {
    throw std::invalid_argument("--update takes --cells or --polygon: what to build anew");
  }
}

// Those that are to be built, where not all are.
std::optional<std::vector<Cell>> chosen_cells(const Options& options, const GridGeometry& occupancy) {
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
                         const OccupancyMap& occupancy, const LidarModel& lidar, MapOptions options) {
  options.checkpoint.reset();
  options.cells.emplace();
  try {
    updated(before, build_alignability_map(scene, occupancy, lidar, options), *options.cells);
  } catch (const std::invalid_argument& error) {
    throw InputError(file, error.what());
  }
}

int build_and_store(Options options) {
  check_choice(options);
  const Interrupt interrupt;
  const auto begin = std::chrono::steady_clock::now();
  const LidarModel lidar = read_lidar_model(options.sensor);
  const OccupancyMap occupancy = read_occupancy_map(options.occupancy);
  const Scene scene(read_meshes(options.scene, options.reading));
  options.map.alignability = for_lidar(options.map.alignability, lidar);
  options.map.cells = chosen_cells(options, occupancy.geometry());
  const auto before = options.update ? std::optional(read_alignability_map(*options.update)) : std::nullopt;
  options.map.stop = interrupt.token();
  if (before) refuse_unless_alike(*options.update, *before, scene, occupancy, lidar, options.map);
  const std::filesystem::path name = output_name(options.output);
  options.map.checkpoint = checkpoint_of(options);
  AlignabilityMap built = build(scene, occupancy, lidar, options.map);
  built.provenance = provenance(options);
  const AlignabilityMap map = before ? updated(*before, built, *options.map.cells) : built;
  draw_alignability_map(map, occupancy, {.title = name.filename().string(), .risk = {}}, with_ending(name, ".png"));
  write_alignability_map(map, name);
  std::filesystem::remove(*options.map.checkpoint);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const Json summary = map_json(built, seconds, {with_ending(name, ".yaml"), with_ending(name, ".tiff"), with_ending(name, ".png")});
  if (options.json) {
    print({summary});
  } else {
    print_summary(summary);
  }
  return kYes;
}

int run(const Options& options) {
  try {
    return build_and_store(options);
  } catch (const Interrupted&) {
    std::cerr << "\nalignability: interrupted; " << checkpoint_of(options).string()
              << " keeps what is done, and the same command goes on from there\n";
    return kInterrupted;
  }
}

}  // namespace

void add_map(CLI::App& app, Work& work) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("map", "Build the alignability map of a site");
  command->add_option("--scene", options->scene, "SDF world or model, or a mesh")->required();
  command->add_option("--occupancy", options->occupancy, "Occupancy map (map_server YAML)")->required();
  command->add_option("--sensor", options->sensor, "Sensor file")->required();
  command->add_option("--resolution", options->map.resolution, "Side of a cell [m]")->check(CLI::PositiveNumber)->capture_default_str();
  command->add_option("--samples", options->map.samples, "Scans a cell")->check(CLI::Range(1, 100000))->capture_default_str();
  command->add_option("--range-max", options->map.range_max, "Crop the sensor's range [m]")->check(CLI::PositiveNumber);
  command->add_option("--floor", options->map.floor, "Height of base_link in map [m]")->capture_default_str();
  command->add_option("--seed", options->map.seed, "Seed of places and range noise")->capture_default_str();
  command->add_option("--threads", options->map.threads, "0: one a processor")->check(CLI::NonNegativeNumber)->capture_default_str();
  add_scoring_options(*command, options->map.alignability);
  command->add_option("--cells", options->cells, "Build these cells alone: column,row from the lower left, from 0")->delimiter(',');
  command->add_option("--polygon", options->polygon, "Build the cells alone that a polygon meets: x,y x,y x,y … [m]")->delimiter(',');
  command->add_option("--update", options->update, "Alignability map, made alike, to take the other cells from");
  command->add_flag("--json", options->json, "Print JSON");
  command
      ->add_option("-o,--output", options->output,
                   "NAME: writes NAME.yaml, NAME.tiff and NAME.png; NAME.part keeps what is done until then")
      ->required();
  add_world_options(*command, options->reading);
  command->footer(
      "Examples:\n"
      "  alignability map --scene maps/warehouse/warehouse.sdf --occupancy maps/warehouse/occupancy.yaml \\\n"
      "    --sensor maps/sensors/hdl32e.yaml --range-max 6.5 --samples 1 -o warehouse\n"
      "  alignability map --scene office.dae --occupancy office.yaml --sensor maps/sensors/os1-64.yaml --seed 7 -o office\n"
      "  alignability map --scene changed.sdf --occupancy changed.yaml --sensor maps/sensors/hdl32e.yaml --range-max 6.5 --samples 1 \\\n"
      "    --polygon 20,10 40,10 40,30 20,30 --update warehouse.yaml -o warehouse\n"
      "A change is seen as far away as the sensor sees: let the polygon reach so far around it.");
  command->callback([options, &work] { work = [options] { return run(*options); }; });
}

}  // namespace alignability::cli
