// SPDX-License-Identifier: BSD-3-Clause
#include "cli/drive_site.hpp"

#include <iostream>

#include "cli/progress_bar.hpp"
#include "cli/scene_options.hpp"
#include "core/input_error.hpp"
#include "localization/drive_file.hpp"
#include "localization/moved_objects.hpp"
#include "localization/survey.hpp"

namespace alignability::cli {
namespace {

const std::filesystem::path& named(const std::optional<std::filesystem::path>& path, const char* key,
                                   const std::filesystem::path& problem_file) {
  if (!path) throw InputError(problem_file, std::string("driving needs the key '") + key + "': a file");
  return *path;
}

std::vector<Localizer> localizers_of(const std::vector<std::string>& names) {
  std::vector<Localizer> localizers;
  for (const std::string& name : names) {
    const auto localizer = localizer_named(name);
    if (!localizer) throw std::invalid_argument("--localizer: " + refusal_of_localizer(name));
    localizers.push_back(*localizer);
  }
  return localizers;
}

// What the localizers know of the site, made as a robot would make it.
std::vector<Eigen::Vector3f> map_cloud(const Scene& scene, const OccupancyMap& occupancy, const SensorRig& sensor,
                                       const DriveOptions& drive, const DriveSiteOptions& options, std::stop_token stop) {
  ProgressBar bar("localizer's map");
  const SurveyOptions survey_options{
      .range_max = drive.range_max, .floor = drive.floor, .threads = options.threads, .progress = bar.callback(), .stop = stop};
  if (options.moved == 0.0) return survey(scene, occupancy, sensor, survey_options);
  MovedObjects site = with_moved_objects(scene.meshes(), options.moved, options.seed);
  std::cerr << site.moved << " of " << site.movable << " loose objects moved in the localizer's map\n";
  return survey(Scene(std::move(site.meshes)), occupancy, sensor, survey_options);
}

}  // namespace

std::vector<CLI::Option*> add_drive_options(CLI::App& command, DriveSiteOptions& options) {
  const std::size_t before = command.get_options().size();
  command.add_option("--drive-file", options.file, "What drives and how it is localized, in place of the problem's file")
      ->type_name("YAML");
  command.add_option("--localizer", options.localizers, "In place of the file's: ndt_mcl_sum, ndt_mcl_product, scan_matching, or several")
      ->type_name("LOCALIZER")
      ->delimiter(',');
  command.add_option("--odometry-bias", options.scale_bias, "Share by which odometry reports the way too long, in place of the file's")
      ->check(CLI::Range(-0.5, 0.5));
  command.add_option("--noise", options.noise, "Standard deviation of ranges [m], in place of the sensor's")->check(CLI::NonNegativeNumber);
  command
      .add_option("--moved", options.moved, "Share of the loose objects (up to 1.6 x 1.6 x 2.2 m) that the localizer's map has elsewhere")
      ->check(CLI::Range(0.0, 1.0));
  command.add_option("--drive-seed", options.seed, "Seed of the first run's errors and of what moved")->capture_default_str();
  command.add_option("--floor", options.floor, "Height of base_link in map [m]")->capture_default_str();
  command.add_option("--threads", options.threads, "0: one a processor")->check(CLI::NonNegativeNumber)->capture_default_str();
  add_site_options(command, options.reading);
  const std::vector<CLI::Option*> all = command.get_options();
  return {all.begin() + static_cast<std::ptrdiff_t>(before), all.end()};
}

DriveOptions drive_options_of(const ProblemFile& problem, const std::filesystem::path& problem_file, const DriveSiteOptions& options) {
  DriveOptions drive = read_drive_file(options.file ? *options.file : named(problem.drive, "drive", problem_file));
  if (!options.localizers.empty()) drive.localizers = localizers_of(options.localizers);
  drive.odometry.scale_bias = options.scale_bias.value_or(drive.odometry.scale_bias);
  drive.range_max = problem.range_max;
  drive.floor = options.floor;
  return drive;
}

SensorRig sensor_of(const ProblemFile& problem, const std::filesystem::path& problem_file, const DriveSiteOptions& options) {
  SensorRig sensor = read_sensor_rig(named(problem.sensor, "sensor", problem_file));
  for (LidarModel& lidar : sensor.lidars) lidar.range_stddev = options.noise.value_or(lidar.range_stddev);
  return sensor;
}

DriveSite load_drive_site(const ProblemFile& problem, const std::filesystem::path& problem_file, const OccupancyMap& occupancy,
                          const DriveSiteOptions& options, std::stop_token stop) {
  DriveOptions drive = drive_options_of(problem, problem_file, options);
  SensorRig sensor = sensor_of(problem, problem_file, options);
  const std::filesystem::path& scene_file = named(problem.scene, "scene", problem_file);
  const Scene scene = read_scene(scene_file, options.reading);
  if (options.moved > 0.0 && !scene.discs().empty()) {
    throw InputError(scene_file, "is a point cloud, in which nothing can be told apart that --moved could move");
  }
  const std::vector<Eigen::Vector3f> cloud = map_cloud(scene, occupancy, sensor, drive, options, stop);
  LocalizationMap map(cloud, for_sensor(drive.localizer, sensor), drive.localizers);
  TrialOptions trials{.drive = std::move(drive), .seed = options.seed, .threads = options.threads, .stop = stop};
  return {scene, std::move(sensor), std::move(map), std::move(trials)};
}

}  // namespace alignability::cli
