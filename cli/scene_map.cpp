// SPDX-License-Identifier: BSD-3-Clause
#include "cli/scene_map.hpp"

#include <cstdio>
#include <iostream>
#include <utility>

#include "cli/output_name.hpp"
#include "cli/progress_bar.hpp"
#include "cli/scene_options.hpp"
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

// A sensor that does not see all around sees another thing at every heading.
int headings_of(const MapCommandOptions& options, const SensorRig& sensor) {
  constexpr int kUsual = 8;
  return options.headings.value_or(sensor.sees_all_around() ? 1 : kUsual);
}

}  // namespace

SceneInputs read_inputs(const MapCommandOptions& options, SceneReader read) {
  SensorRig sensor = read_sensor_rig(*options.sensor);
  OccupancyMap occupancy = read_occupancy_map(*options.occupancy);
  Scene scene = read(options.scene, options.reading);
  MapOptions map = options.map;
  map.headings = headings_of(options, sensor);
  map.alignability = for_lidar(map.alignability, sensor);
  return {std::move(sensor), std::move(occupancy), std::move(scene), std::move(map)};
}

std::string digest(const SceneInputs& inputs) {
  char text[17];
  const unsigned long long fingerprint = map_fingerprint(inputs.scene, inputs.occupancy, inputs.sensor, inputs.map);
  std::snprintf(text, sizeof text, "%016llx", fingerprint);
  return text;
}

int threads_of(const MapCommandOptions& options, const Ranks& ranks) {
  return options.map.threads > 0 || ranks.is_alone() ? options.map.threads : ranks.processors();
}

std::filesystem::path checkpoint_of(const MapCommandOptions& options) {
  const bool whole = options.cells.empty() && options.polygon.empty();
  return with_ending(output_name(options.output), whole ? ".part" : ".cells.part");
}

AlignabilityMap build_telling(const SceneInputs& inputs, const MapCommandOptions& options, const std::string& label) {
  ProgressBar bar(label);
  MapOptions map = inputs.map;
  map.checkpoint = checkpoint_of(options);
  map.progress = telling_of_the_start(bar.callback(), *map.checkpoint);
  AlignabilityMap built = build_alignability_map(inputs.scene, inputs.occupancy, inputs.sensor, map);
  built.provenance = provenance(options);
  return built;
}

void help_to_build(const MapCommandOptions& options, Ranks& ranks, const std::stop_token& stop) {
  std::optional<SceneInputs> inputs;
  const bool wanted = is_wanted(ranks, [&] {
    inputs = read_inputs(options, read_scene_quietly);
    return digest(*inputs);
  });
  if (!wanted) return;
  inputs->map.cells.emplace();  // the leading rank says which
  inputs->map.threads = threads_of(options, ranks);
  inputs->map.stop = stop;
  inputs->map.spread = spread_for_the_lead(ranks);
  build_alignability_map(inputs->scene, inputs->occupancy, inputs->sensor, inputs->map);
}

}  // namespace alignability::cli
