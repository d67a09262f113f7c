// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <iostream>

#include "cli/command.hpp"
#include "cli/scene_options.hpp"
#include "core/pose.hpp"
#include "lidar/scan_file.hpp"
#include "lidar/scene.hpp"
#include "lidar/sensor_rig.hpp"
#include "lidar/simulate_scan.hpp"

namespace alignability::cli {
namespace {

struct Options {
  std::filesystem::path scene;
  SiteOptions reading;
  std::filesystem::path sensor;
  std::vector<double> at;
  double floor = 0.0;
  std::optional<double> range_max;
  std::uint64_t seed = 1;
  bool noise_free = false;
  std::filesystem::path output;
};

int run(const Options& options) {
  const SensorRig sensor = read_sensor_rig(options.sensor);
  const Scene scene = read_scene(options.scene, options.reading);
  Eigen::Isometry3d T_map_base = Eigen::Isometry3d::Identity();
  T_map_base.translation() << options.at[0], options.at[1], options.floor;
  T_map_base.rotate(Eigen::AngleAxisd(options.at[2], Eigen::Vector3d::UnitZ()));
  const auto noise = options.noise_free ? std::nullopt : std::optional(NoiseKey{.seed = options.seed});
  const Scan scan = simulate_rig_scan(scene, sensor, T_map_base, {.range_max = options.range_max}, noise);
  write_pcd(scan, options.output);
  const auto returns = std::ranges::count_if(scan.points, [](const Eigen::Vector3f& point) { return point.allFinite(); });
  std::cout << options.output.string() << ": " << scan.rings << " x " << scan.columns << " beams of " << sensor.name << ", " << returns
            << " returns\n";
  return kYes;
}

}  // namespace

void add_scan(CLI::App& app, Work& work) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("scan", "Simulate one lidar scan of a world");
  command->add_option("--scene", options->scene, kSiteHelp)->type_name("FILE")->required();
  command->add_option("--sensor", options->sensor, "Sensor file")->type_name("YAML")->required();
  command->add_option("--at", options->at, "Where base_link stands in map: x,y,yaw [m, m, rad]")->required()->expected(3)->delimiter(',');
  command->add_option("--floor", options->floor, "Height of base_link in map [m]")->capture_default_str();
  command->add_option("--range-max", options->range_max, "Drop returns beyond [m]")->check(CLI::PositiveNumber);
  command->add_option("--seed", options->seed, "Seed of the range noise")->capture_default_str();
  command->add_flag("--noise-free", options->noise_free, "Exact ranges");
  command->add_option("-o,--output", options->output, "FILE.pcd, organized: a row a ring; of several lidars one row in base_link")
      ->type_name("FILE")
      ->required();
  add_site_options(*command, options->reading);
  command->footer(
      "Examples:\n"
      "  alignability scan --scene maps/warehouse/warehouse.sdf --sensor maps/sensors/hdl32e.yaml --at 5,20,0 -o scan.pcd\n"
      "  alignability scan --scene office.dae --sensor maps/sensors/vlp16.yaml --at 2,3,1.57 --noise-free -o office.pcd");
  command->callback([options, &work] { work = [options] { return run(*options); }; });
}

}  // namespace alignability::cli
