// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <chrono>
#include <iostream>
#include <utility>

#include "alignability/map_update.hpp"
#include "cli/exit_code.hpp"
#include "cli/interrupt.hpp"
#include "cli/map_output.hpp"
#include "cli/output_name.hpp"
#include "cli/scene_map.hpp"
#include "cli/scene_options.hpp"
#include "core/input_error.hpp"

namespace alignability::cli {
namespace {

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
void refuse_unless_alike(const std::filesystem::path& file, const AlignabilityMap& before, const SceneInputs& inputs) {
  MapOptions options = inputs.map;
  options.cells.emplace();
  try {
    updated(before, build_alignability_map(inputs.scene, inputs.occupancy, inputs.sensor, options), *options.cells);
  } catch (const std::invalid_argument& error) {
    throw InputError(file, error.what());
  }
}

int build_and_store(const MapCommandOptions& options, Ranks& ranks, const std::stop_token& stop) {
  check_choice(options);
  const auto begin = std::chrono::steady_clock::now();
  LedWork work(ranks, stop);
  SceneInputs inputs = read_inputs(options, read_scene);
  work.compare([&] { return digest(inputs); });
  inputs.map.cells = chosen_cells(options, inputs.occupancy.geometry());
  inputs.map.threads = threads_of(options, ranks);
  inputs.map.stop = stop;
  const auto before = options.update ? std::optional(read_alignability_map(*options.update)) : std::nullopt;
  if (before) refuse_unless_alike(*options.update, *before, inputs);
  inputs.map.spread = work.spread();
  const AlignabilityMap built = build_telling(inputs, options, "alignability map");
  const std::filesystem::path name = output_name(options.output);
  store_map(before ? updated(*before, built, *inputs.map.cells) : built, inputs.occupancy, name, options.pictures);
  std::filesystem::remove(checkpoint_of(options));
  tell(map_json(built, seconds_since(begin), map_files(name, options.pictures)), options.json);
  return kYes;
}

int lead(const MapCommandOptions& options, Ranks& ranks, const std::stop_token& stop) {
  try {
    return build_and_store(options, ranks, stop);
  } catch (const Interrupted&) {
    std::cerr << "\nalignability: interrupted; " << checkpoint_of(options).string()
              << " keeps what is done, and the same command goes on from there\n";
    return kInterrupted;
  }
}

}  // namespace

int map_from_scene(const MapCommandOptions& options) {
  const Interrupt interrupt;
  Ranks ranks;
  return run_on_ranks(
      ranks, [&] { return lead(options, ranks, interrupt.token()); }, [&] { help_to_build(options, ranks, interrupt.token()); });
}

}  // namespace alignability::cli
