// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "lidar/site.hpp"
#include "localization/trials.hpp"
#include "planner/plan_problem.hpp"

namespace alignability::cli {

/// What the command line says of driving.
struct DriveSiteOptions {
  std::optional<std::filesystem::path> file;  ///< in place of the problem's
  std::vector<std::string> localizers;        ///< in place of the file's
  std::optional<double> scale_bias;           ///< of odometry, likewise
  std::optional<double> noise;                ///< of ranges [m], in place of the sensor's
  double moved = 0.0;                         ///< share of the loose things that the localizer's map has elsewhere
  std::uint64_t seed = 1;                     ///< of the first run
  double floor = 0.0;                         ///< z of base_link in map [m]
  int threads = 0;
  SiteOptions reading;
};

/// All but the number of runs; those that it added.
std::vector<CLI::Option*> add_drive_options(CLI::App& command, DriveSiteOptions& options);

/// How the site of a problem is driven. Throws InputError.
DriveOptions drive_options_of(const ProblemFile& problem, const std::filesystem::path& problem_file, const DriveSiteOptions& options);

/// The problem's sensor as it is driven. Throws InputError.
SensorRig sensor_of(const ProblemFile& problem, const std::filesystem::path& problem_file, const DriveSiteOptions& options);

/// A site to drive in.
struct DriveSite {
  Scene scene;
  SensorRig sensor;
  LocalizationMap map;
  TrialOptions trials;  ///< all but the number of runs and the progress
};

/// Reads what a problem names and surveys the localizer's map, with progress bars. Throws InputError, for a problem that names no scene,
/// sensor or drive too, and Interrupted.
DriveSite load_drive_site(const ProblemFile& problem, const std::filesystem::path& problem_file, const OccupancyMap& occupancy,
                          const DriveSiteOptions& options, std::stop_token stop);

}  // namespace alignability::cli
