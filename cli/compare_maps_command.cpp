// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>
#include <memory>

#include "cli/command.hpp"
#include "cli/compare_maps_output.hpp"
#include "cli/map_output.hpp"
#include "cli/output_name.hpp"
#include "cli/picture_option.hpp"
#include "core/file.hpp"
#include "core/input_error.hpp"
#include "costmap/map_server.hpp"
#include "pictures/alignability_difference_picture.hpp"

namespace alignability::cli {
namespace {

struct Options {
  std::filesystem::path first;
  std::filesystem::path second;
  std::optional<std::filesystem::path> occupancy;
  MapComparisonOptions comparison;
  std::size_t worst = 10;
  bool json = false;
  std::optional<std::filesystem::path> output;
  PictureKinds pictures;
};

MapComparison compare(const Options& options, const AlignabilityMap& first, const AlignabilityMap& second) {
  try {
    return compare_maps(first, second, options.comparison);
  } catch (const std::invalid_argument& error) {
    throw InputError(options.second, "cannot be compared with " + options.first.string() + ": the maps " + error.what());
  }
}

void store(const Options& options, const AlignabilityMap& first, const MapComparison& comparison, const Json& summary) {
  const std::filesystem::path name = output_name(*options.output);
  const OccupancyMap occupancy = options.occupancy ? read_occupancy_map(*options.occupancy) : open_ground(first.geometry);
  const std::string title = options.second.filename().string() + " against " + options.first.filename().string();
  for (const auto& file : picture_files(name, options.pictures)) {
    draw_alignability_difference(comparison, first.geometry, occupancy, title, file);
  }
  write_file(with_ending(name, ".json"), summary.dump(2) + '\n');
}

int run(const Options& options) {
  const AlignabilityMap first = read_alignability_map(options.first);
  const AlignabilityMap second = read_alignability_map(options.second);
  const std::vector<std::string> made_differently = differences_in_making(first, second);
  for (const std::string& difference : made_differently) {
    std::cerr << "warning: the two maps were made differently: " << difference << '\n';
  }
  const MapComparison comparison = compare(options, first, second);
  Json summary = comparison_json(comparison, options.comparison, options.worst);
  summary["made_differently"] = made_differently;
  if (options.output) store(options, first, comparison, summary);
  if (options.json) {
    print({summary});
  } else {
    print_comparison(comparison, options.comparison, options.worst, options.first.filename().string(), options.second.filename().string());
  }
  if (!comparison.is_tested) {
    std::cerr << "warning: neither map has cells with four samples or more, so nothing tells how far a value may be off: cells were not "
                 "tested one by one\n";
  }
  if (comparison.lower == 0 && !comparison.is_lower_as_whole) return kYes;
  std::cerr << "warning: " << options.second.string() << " reads lower "
            << (comparison.lower > 0
                    ? "in " + std::to_string(comparison.lower) + " of " + std::to_string(comparison.cells.size()) + " cells"
                    : "as a whole")
            << ", by more than chance explains: the site has changed, or scans are taken otherwise\n";
  return kNo;
}

}  // namespace

void add_compare_maps(CLI::App& app, Work& work) {
  const auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("compare-maps", "Compare two alignability maps of one site, and tell whether the second reads lower");
  command->add_option("first", options->first, "Alignability map: what is known of the site")->type_name("YAML")->required();
  command->add_option("second", options->second, "Alignability map: a live log, or the site after a change")->type_name("YAML")->required();
  command->add_option("--occupancy", options->occupancy, "Occupancy map (map_server YAML), for the picture's walls")->type_name("YAML");
  MapComparisonOptions& comparison = options->comparison;
  command->add_option("--alpha-critical", comparison.alpha_critical, "Below it a place is blind")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  command->add_option("--alpha-safe", comparison.alpha_safe, "At or above it a place is safe")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  command->add_option("--margin", comparison.margin, "How much lower alpha may be before it is a change")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  command->add_option("--worst", options->worst, "How many cells to list, the greatest fall first")->capture_default_str();
  command->add_flag("--json", options->json, "Print JSON");
  command->add_option("-o,--output", options->output, "NAME: writes NAME.png, the difference drawn, and NAME.json")->type_name("NAME");
  add_picture_option(*command, options->pictures);
  command->footer(
      "Examples:\n"
      "  alignability compare-maps simulated.yaml logged.yaml --occupancy site.yaml -o change\n"
      "  alignability compare-maps before.yaml after.yaml --json\n"
      "Ends with 1 where the second map reads lower than margin and spread of both maps allow.");
  command->callback([options, &work] { work = [options] { return run(*options); }; });
}

}  // namespace alignability::cli
