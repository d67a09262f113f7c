// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <memory>
#include <set>
#include <string>

#include "cli/command.hpp"
#include "cli/launcher.hpp"
#include "cli/map_builds.hpp"
#include "cli/picture_option.hpp"
#include "cli/scene_options.hpp"
#include "cli/scoring_options.hpp"
#include "lidar/carmen_log.hpp"

namespace alignability::cli {
namespace {

using Names = std::set<std::string>;

void add_options_of_scenes(CLI::App& command, MapCommandOptions& options) {
  command.add_option("--samples", options.map.samples, "Scans a cell")->check(CLI::Range(1, 100000))->capture_default_str();
  command
      .add_option(
          "--headings", options.headings,
          "So many headings of the robot, a layer each; 1: yaw 0 alone, none (default: 8 for a sensor that does not see all around)")
      ->check(CLI::Range(1, 360));
  command.add_option("--floor", options.map.floor, "Height of base_link in map [m]")->capture_default_str();
  command.add_option("--seed", options.map.seed, "Seed of places and range noise")->capture_default_str();
  command.add_option("--cells", options.cells, "Build these cells alone: column,row from the lower left, from 0")->delimiter(',');
  command.add_option("--polygon", options.polygon, "Build the cells alone that a polygon meets: x,y x,y x,y … [m]")->delimiter(',');
  command.add_option("--update", options.update, "Alignability map, made alike, to take the other cells from")->type_name("YAML");
  add_site_options(command, options.reading);
}

void add_options_of_both(CLI::App& command, MapCommandOptions& options) {
  command
      .add_option("--occupancy", options.occupancy,
                  "Occupancy map (map_server YAML), whose grid the cells have; of a log without it, a grid around its scans")
      ->type_name("YAML");
  command.add_option("--sensor", options.sensor, "Sensor file; of a log for least range, noise and mount (without: 0.5 m, 2 cm, none)")
      ->type_name("YAML");
  command.add_option("--resolution", options.map.resolution, "Side of a cell [m]")->check(CLI::PositiveNumber)->capture_default_str();
  command.add_option("--range-max", options.map.range_max, "Crop the sensor's range [m]")->check(CLI::PositiveNumber);
  command.add_option("--threads", options.map.threads, "0: one a processor")->check(CLI::NonNegativeNumber)->capture_default_str();
  add_scoring_options(command, options.map.alignability);
}

const Names kOfScenesAlone{"--samples",    "--headings", "--floor", "--seed", "--cells", "--polygon", "--update",
                           "--model-path", "--geometry", "--unit",  "--up",   "--thin",  "--level"};
const Names kOfLogsAlone{"--trajectory", "--pair-by", "--poses-of", "--max-gap"};
const Names kOfMerging{"--merge", "--occupancy", "--json", "--output", "--pictures"};
const Names kOfSites{"--sites", "--threads", "--json", "--pictures"};

// Refuses options that were given and mean nothing to the source.
template <typename MeansNothing>
void refuse_beside(const CLI::App& command, const CLI::Option& source, MeansNothing means_nothing) {
  for (const CLI::Option* option : command.get_options()) {
    if (option->count() > 0 && means_nothing(option->get_name())) throw CLI::ExcludesError(option->get_name(), source.get_name());
  }
}

void require(const CLI::App& command, const std::string& source, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    if (command.get_option(name)->count() == 0) throw CLI::RequiresError(source, name);
  }
}

void refuse_strangers(const CLI::App& command, const CLI::Option& scene, const CLI::Option& log, const CLI::Option& merge,
                      const CLI::Option& sites) {
  if (sites.count() > 0) return refuse_beside(command, sites, [](const std::string& name) { return !kOfSites.contains(name); });
  if (merge.count() > 0) {
    refuse_beside(command, merge, [](const std::string& name) { return !kOfMerging.contains(name); });
  } else if (log.count() > 0) {
    refuse_beside(command, log, [](const std::string& name) { return name == "--scene" || kOfScenesAlone.contains(name); });
    const bool has_poses = is_carmen_log(log.as<std::filesystem::path>());
    if (!has_poses && command.get_option("--trajectory")->count() == 0) throw CLI::RequiresError("--log", "--trajectory");
    if (has_poses) refuse_beside(command, log, [](const std::string& name) { return kOfLogsAlone.contains(name); });
  } else {
    if (scene.count() == 0) throw CLI::RequiredError("One of --scene, --log, --merge and --sites");
    refuse_beside(command, scene, [](const std::string& name) { return kOfLogsAlone.contains(name); });
    require(command, "--scene", {"--occupancy", "--sensor"});
  }
  if (command.get_option("--output")->count() == 0) throw CLI::RequiredError("--output");
}

int run(const MapCommandOptions& options) {
  if (!options.sites.empty()) return map_from_sites(options);
  if (!options.scene.empty()) return map_from_scene(options);
  refuse_several_processes(options.merge.empty() ? "'map --log'" : "'map --merge'");
  return options.merge.empty() ? map_from_log(options) : map_from_two(options);
}

}  // namespace

void add_map(CLI::App& app, Work& work) {
  const auto options = std::make_shared<MapCommandOptions>();
  CLI::App* command = app.add_subcommand("map", "Build the alignability map of a site, from a scene or from recorded scans");
  const CLI::Option* scene =
      command->add_option("--scene", options->scene, "SDF world or model, mesh, or point cloud, to simulate scans in")->type_name("FILE");
  const CLI::Option* log =
      command->add_option("--log", options->log.folder, "Or a folder of recorded scans: .pcd, .ply, .bin; or a CARMEN log: .log, .clf")
          ->type_name("PATH");
  add_log_options(*command, options->log);
  const CLI::Option* merge = command->add_option("--merge", options->merge, "Or two maps, to be one: a log's values win, else the first's")
                                 ->type_name("YAML")
                                 ->expected(2);
  const CLI::Option* sites =
      command->add_option("--sites", options->sites, "Or a file of many sites, a map of each; takes --threads, --json and --pictures alone")
          ->type_name("YAML");
  add_options_of_both(*command, *options);
  add_options_of_scenes(*command, *options);
  command->add_flag("--json", options->json, "Print JSON");
  command
      ->add_option("-o,--output", options->output,
                   "NAME: writes NAME.yaml, NAME.tiff and NAME.png; of a log NAME.csv too, a line a scan; of a scene NAME.part keeps what "
                   "is done until then; required, but for --sites, which says itself where its maps go")
      ->type_name("NAME");
  add_picture_option(*command, options->pictures);
  command->footer(
      "Examples:\n"
      "  alignability map --scene maps/warehouse/warehouse.sdf --occupancy maps/warehouse/occupancy.yaml \\\n"
      "    --sensor maps/sensors/hdl32e.yaml --range-max 6.5 --samples 1 -o warehouse\n"
      "  alignability map --scene office.dae --occupancy office.yaml --sensor maps/sensors/os1-64.yaml --seed 7 -o office\n"
      "  alignability map --scene changed.sdf --occupancy changed.yaml --sensor maps/sensors/hdl32e.yaml --range-max 6.5 --samples 1 \\\n"
      "    --polygon 20,10 40,10 40,30 20,30 --update warehouse.yaml -o warehouse\n"
      "  alignability map --log scans --trajectory poses.txt --occupancy site.yaml -o logged\n"
      "  alignability map --log csail.log -o csail\n"
      "  alignability map --merge logged.yaml simulated.yaml --occupancy site.yaml -o merged\n"
      "  alignability map --sites sites.yaml\n"
      "  mpirun -n 2 alignability map --sites sites.yaml\n"
      "A change is seen as far away as the sensor sees: let the polygon reach so far around it.");
  command->callback([options, command, scene, log, merge, sites, &work] {
    refuse_strangers(*command, *scene, *log, *merge, *sites);
    work = [options] { return run(*options); };
  });
}

}  // namespace alignability::cli
