// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>
#include <stdexcept>

#include "cli/command.hpp"
#include "cli/scene_options.hpp"
#include "core/input_error.hpp"
#include "lidar/sample_surface.hpp"
#include "lidar/scan_file.hpp"

namespace alignability::cli {
namespace {

struct Options {
  std::filesystem::path site;
  SiteOptions reading;
  SampleOptions sampling;
  std::filesystem::path output;
};

int run(const Options& options) {
  const Site site = read_site_telling(options.site, options.reading);
  if (site.meshes.empty()) throw InputError(options.site, "has no surfaces to sample: it is points already");
  Scan cloud{.points = sample_surface(site.meshes, options.sampling).points};
  if (cloud.points.empty()) throw std::invalid_argument("--spacing is so wide that no point falls on a surface");
  cloud.columns = static_cast<int>(cloud.points.size());
  write_pcd(cloud, options.output);
  std::cout << options.output.string() << ": " << cloud.points.size() << " points\n";
  return kYes;
}

}  // namespace

void add_sample(CLI::App& app, Work& work) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("sample", "Sample the surfaces of a world into a point cloud, as a scanner would have them");
  command->add_option("site", options->site, "SDF world or model, or mesh")->type_name("FILE")->required();
  command->add_option("--spacing", options->sampling.spacing, "One point for each square of this side [m], on average")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_option("--noise", options->sampling.stddev, "Standard deviation of the points off their surface [m]")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command->add_option("--seed", options->sampling.seed, "Seed of where points lie and of their noise")->capture_default_str();
  command->add_option("-o,--output", options->output, "FILE.pcd")->type_name("FILE")->required();
  add_site_options(*command, options->reading);
  command->footer(
      "Examples:\n"
      "  alignability sample maps/warehouse/warehouse.sdf --spacing 0.1 -o warehouse.pcd\n"
      "  alignability sample office.dae --spacing 0.05 --noise 0.01 -o office.pcd");
  command->callback([options, &work] { work = [options] { return run(*options); }; });
}

}  // namespace alignability::cli
