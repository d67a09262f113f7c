// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>

#include "cli/command.hpp"
#include "cli/output_name.hpp"
#include "cli/scene_options.hpp"
#include "core/input_error.hpp"
#include "costmap/map_server.hpp"
#include "costmap/occupancy_patches.hpp"
#include "lidar/slice.hpp"

namespace alignability::cli {
namespace {

// What is mended of a map made of points [m²].
constexpr double kLeastPatchOfCloud = 1.0;
constexpr double kLeastHoleOfCloud = 0.1;

struct Options {
  std::filesystem::path world;
  SiteOptions reading;
  double z_min = 0.0;
  double z_max = 0.0;
  double resolution = 0.1;
  double least_patch = kLeastPatchOfCloud;
  std::filesystem::path output;
};

int run(const Options& options) {
  if (options.z_min >= options.z_max) throw std::invalid_argument("--z-min must be less than --z-max");
  const Site site = read_site_telling(options.world, options.reading);
  const bool is_cloud = !site.discs.empty();
  const Slice band = is_cloud ? slice(site.discs, options.z_min, options.z_max) : slice(site.meshes, options.z_min, options.z_max);
  if (band.surfaces.empty()) throw InputError(options.world, "has nothing between --z-min and --z-max");
  const GridGeometry geometry = geometry_around(band, options.resolution);
  OccupancyMap map = rasterize(band, geometry);
  if (is_cloud) map = without_small_patches(without_small_holes(map, kLeastHoleOfCloud), options.least_patch);
  std::size_t free = 0;
  std::size_t unknown = 0;
  for (std::size_t i = 0; i < geometry.size(); ++i) {
    if (map.is_free(i)) ++free;
    if (!map.occupancy(geometry.cell_of(i))) ++unknown;
  }
  const std::filesystem::path name = output_name(options.output);
  write_occupancy_map(map, name);
  std::cout << name.string() << ".yaml: " << geometry.width << " x " << geometry.height << " cells of " << geometry.resolution << " m, "
            << free << " free, " << geometry.size() - free - unknown << " occupied, " << unknown << " unknown\n";
  return kYes;
}

}  // namespace

void add_occupancy(CLI::App& app, Work& work) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("occupancy", "Slice a world, mesh or point cloud into an occupancy map for map_server");
  command->add_option("world", options->world, kSiteHelp)->type_name("FILE")->required();
  command->add_option("--z-min", options->z_min, "Bottom of the slice [m]: what is lower is floor")->required();
  command->add_option("--z-max", options->z_max, "Top of the slice [m]: what is higher is passed under")->required();
  command->add_option("--resolution", options->resolution, "Side of a cell [m]")->check(CLI::PositiveNumber)->capture_default_str();
  command
      ->add_option("--least-patch", options->least_patch, "Of a point cloud: smaller free patches [m2] are taken for the inside of walls")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command->add_option("-o,--output", options->output, "NAME: writes NAME.yaml and NAME.pgm")->type_name("NAME")->required();
  add_site_options(*command, options->reading);
  command->footer(
      "Examples:\n"
      "  alignability occupancy maps/warehouse/warehouse.sdf --z-min 0.1 --z-max 2 -o occupancy\n"
      "  alignability occupancy office.dae --z-min 0.2 --z-max 1.5 --resolution 0.05 -o office");
  command->callback([options, &work] { work = [options] { return run(*options); }; });
}

}  // namespace alignability::cli
