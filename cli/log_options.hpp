// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>

#include "lidar/lidar_model.hpp"
#include "lidar/scan_log.hpp"

namespace alignability::cli {

/// A folder of scans and where they were taken, or a CARMEN log, which has both.
struct LogOptions {
  std::filesystem::path folder;
  std::filesystem::path trajectory;
  ScanLogOptions reading;
};

/// Adds --trajectory, --pair-by, --poses-of and --max-gap.
void add_log_options(CLI::App& command, LogOptions& options);

/// Refuses a folder without a trajectory, and a CARMEN log with one. Pairs scans and poses, and tells on stderr of scans without one.
/// Throws std::invalid_argument where poses are those of base_link and there is no sensor whose mount says where the lidar is.
ScanLog read_log(const LogOptions& options, const std::optional<LidarModel>& lidar);

}  // namespace alignability::cli
