// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stop_token>
#include <string>

#include "cli/crew.hpp"
#include "cli/map_builds.hpp"

namespace alignability::cli {

/// What the scans of a map are simulated in and with.
struct SceneInputs {
  SensorRig sensor;
  OccupancyMap occupancy;
  Scene scene;
  MapOptions map;  ///< as asked for, and as the sensor needs
};

using SceneReader = Scene (*)(const std::filesystem::path& file, const SiteOptions& options);

/// Throws InputError.
SceneInputs read_inputs(const MapCommandOptions& options, SceneReader read);

/// The fingerprint of the map, in sixteen hexadecimal digits.
std::string digest(const SceneInputs& inputs);

/// How many threads a rank is to run: as many as asked for, else its share of its machine's processors.
int threads_of(const MapCommandOptions& options, const Ranks& ranks);

/// Where what is done is kept until the map is stored. A part's is another's than the whole's, which it would remove at its end.
std::filesystem::path checkpoint_of(const MapCommandOptions& options);

/// The map, whose provenance names the files, and a bar of that label on the way.
AlignabilityMap build_telling(const SceneInputs& inputs, const MapCommandOptions& options, const std::string& label);

/// The part of a rank that does not lead.
void help_to_build(const MapCommandOptions& options, Ranks& ranks, const std::stop_token& stop);

}  // namespace alignability::cli
