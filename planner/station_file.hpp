// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/pose.hpp"

namespace alignability {

/// A place that a fleet drives to and from.
struct Station {
  std::string name;
  Pose2 pose;
};

/// Reads `stations: {dock: [x, y, yaw], …}`, at least two, in the order of the file. Throws InputError.
std::vector<Station> read_station_file(const std::filesystem::path& yaml_file);

}  // namespace alignability
