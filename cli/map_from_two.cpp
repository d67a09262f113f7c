// SPDX-License-Identifier: BSD-3-Clause
#include <chrono>
#include <iostream>

#include "alignability/merged_map.hpp"
#include "cli/exit_code.hpp"
#include "cli/map_builds.hpp"
#include "cli/map_output.hpp"
#include "cli/output_name.hpp"
#include "core/input_error.hpp"
#include "costmap/map_comparison.hpp"
#include "costmap/map_server.hpp"

namespace alignability::cli {
namespace {

MergedMap merge(const std::filesystem::path& first_file, const AlignabilityMap& first, const AlignabilityMap& second) {
  try {
    return merged(first, second);
  } catch (const std::invalid_argument& error) {
    throw InputError(first_file, "cannot be merged with the other map: the maps " + std::string(error.what()));
  }
}

}  // namespace

int map_from_two(const MapCommandOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  const AlignabilityMap first = read_alignability_map(options.merge[0]);
  const AlignabilityMap second = read_alignability_map(options.merge[1]);
  const auto occupancy = options.occupancy ? std::optional(read_occupancy_map(*options.occupancy)) : std::nullopt;
  for (const std::string& difference : differences_in_making(first, second)) {
    std::cerr << "warning: the two maps were made differently: " << difference << '\n';
  }
  MergedMap result = merge(options.merge[0], first, second);
  if (result.lost > 0) std::cerr << "warning: " << result.lost << " cells with values lie off the map that is kept, and are left out\n";
  if (first.error_model || second.error_model) {
    std::cerr << "warning: the error model is left out: it was fitted to other values; calibrate anew\n";
  }
  result.map.provenance = "merged: [" + options.merge[0].filename().string() + ", " + options.merge[1].filename().string() +
                          "]\nmade_by: alignability " ALIGNABILITY_VERSION "\n";
  const std::filesystem::path name = output_name(options.output);
  store_map(result.map, occupancy.value_or(open_ground(result.map.geometry)), name, options.pictures);
  Json summary = map_json(result.map, seconds_since(begin), map_files(name, options.pictures));
  summary["cells_taken"] = result.taken;
  tell(summary, options.json);
  return kYes;
}

}  // namespace alignability::cli
