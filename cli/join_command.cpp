// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>
#include <memory>

#include "cli/command.hpp"
#include "cli/interrupt.hpp"
#include "cli/json.hpp"
#include "cli/log_options.hpp"
#include "cli/progress_bar.hpp"
#include "lidar/joined_scans.hpp"
#include "lidar/scan_file.hpp"

namespace alignability::cli {
namespace {

struct Options {
  LogOptions log;
  std::optional<std::filesystem::path> sensor;
  std::optional<double> range_min;
  JoinOptions join;
  bool json = false;
  std::filesystem::path output;
};

std::vector<Eigen::Vector3f> cloud_of(const ScanLog& log, JoinOptions options) {
  ProgressBar bar("scans");
  options.progress = bar.callback();
  return joined(log.scans, options);
}

int run(Options options) {
  if (options.output.extension() != ".pcd") throw std::invalid_argument("--output: the cloud is written as PCD: name it CLOUD.pcd");
  const Interrupt interrupt;
  const auto lidar = options.sensor ? std::optional(read_lidar_model(*options.sensor)) : std::nullopt;
  const ScanLog log = read_log(options.log, lidar);
  if (lidar) options.join.range_min = lidar->range_min;
  if (options.range_min) options.join.range_min = *options.range_min;
  options.join.stop = interrupt.token();
  Scan cloud{.points = cloud_of(log, options.join), .rings = 1, .columns = 0};
  cloud.columns = static_cast<int>(cloud.points.size());
  if (cloud.points.empty()) throw std::invalid_argument("the scans have no points between --range-min and --range-max");
  write_pcd(cloud, options.output);
  if (options.json) {
    print({{{"scans", log.scans.size()},
            {"scans_without_a_pose", log.without_a_pose.size()},
            {"points", cloud.points.size()},
            {"files", {options.output.string()}}}});
  } else {
    std::cout << options.output.string() << ": " << cloud.points.size() << " points of " << log.scans.size() << " scans\n";
  }
  return kYes;
}

}  // namespace

void add_join(CLI::App& app, Work& work) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("join", "Join the scans of a log by their poses into one point cloud in map");
  command->add_option("log", options->log.folder, "Folder of recorded scans: .pcd, .ply, .bin; or a CARMEN log: .log, .clf")
      ->type_name("PATH")
      ->required();
  add_log_options(*command, options->log);
  command->add_option("--sensor", options->sensor, "Sensor file: least range and mount")->type_name("YAML");
  command->add_option("--range-min", options->range_min, "Drop nearer returns: the robot's own, and fillers (without --sensor 0.5) [m]")
      ->check(CLI::NonNegativeNumber);
  command->add_option("--range-max", options->join.range_max, "Drop farther returns [m]")->check(CLI::PositiveNumber);
  command->add_option("--thin", options->join.thinning, "Thin to about a point in each cube of this side [m]")->check(CLI::PositiveNumber);
  command->add_flag("--json", options->json, "Print JSON");
  command->add_option("-o,--output", options->output, "CLOUD.pcd")->type_name("FILE")->required();
  command->footer(
      "Examples:\n"
      "  alignability join scans --trajectory poses.txt -o cloud.pcd\n"
      "  alignability join scans --trajectory poses.txt --poses-of base_link --sensor maps/sensors/os1-64.yaml --thin 0.05 -o cloud.pcd");
  command->callback([options, &work] { work = [options] { return run(*options); }; });
}

}  // namespace alignability::cli
