// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <iostream>
#include <limits>

#include "cli/command.hpp"
#include "cli/drive_paths.hpp"
#include "cli/json.hpp"
#include "cli/output_name.hpp"
#include "cli/problem_options.hpp"
#include "core/file.hpp"
#include "core/range.hpp"
#include "costmap/cost_mask.hpp"
#include "costmap/heading_layers.hpp"
#include "costmap/map_table.hpp"
#include "planner/path_export.hpp"

namespace alignability::cli {
namespace {

struct Options {
  ProblemOptions problem;
  std::vector<std::filesystem::path> paths;
  bool json = false;
  std::filesystem::path output;
};

// The most that the risk can be where several sources add up.
double most_risk(const RiskField& risk) {
  double most = 0.0;
  for (const RiskLayer& layer : risk.layers()) most += layer.weight;
  return std::max(most, 1.0);
}

// α at the worst heading alone: a mask knows of no headings.
AlignabilityMap at_the_worst_heading(AlignabilityMap map) {
  const std::size_t headings = heading_layers(map).size();
  if (headings == 0) return map;
  std::cerr << "the mask holds the worst of " << headings << " headings\n";
  std::erase_if(map.layers, [&](const AlignabilityMap::Layer& layer) {
    for (std::size_t k = 0; k < headings; ++k) {
      if (layer.name == heading_layer_name(k)) return true;
    }
    return false;
  });
  return map;
}

// At the centres of the occupancy map's cells; NaN where the problem lets the robot not be.
Grid<double> shares(const RiskField& risk, const OccupancyMap& occupancy) {
  const GridGeometry& cells = occupancy.geometry();
  Grid<double> shares(cells, 0.0);
  const double most = most_risk(risk);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Eigen::Vector2d at = cells.center(cells.cell_of(i));
    const bool is_barred = occupancy.is_free(i) && !risk.is_drivable(at);
    shares[i] = is_barred ? std::numeric_limits<double>::quiet_NaN() : std::clamp(risk.risk(at.x(), at.y(), 0.0) / most, 0.0, 1.0);
  }
  return shares;
}

// What to paste into nav2's parameters. Smac 2D prices a cell at 1 + cost_travel_multiplier · cost / 252 of its length, which is then
// what our objective does.
std::string nav2_parameters(const std::filesystem::path& mask, double weight, double most) {
  constexpr double kCostOfOne = 252.0;
  return "# Risk of losing localization as a costmap filter. Start a map_server for the mask and a costmap_filter_info_server beside it,\n"
         "# and bring both up with your lifecycle manager. The mask must stay in mode scale, its thresholds at 0 and 1, or its grades are "
         "lost;\n"
         "# filters come after the inflation layer, which must not follow them.\n"
         "alignability_mask_server:\n"
         "  ros__parameters:\n"
         "    yaml_filename: " +
         mask.string() +
         "\n"
         "    topic_name: alignability_mask\n"
         "    frame_id: map\n"
         "alignability_filter_info_server:\n"
         "  ros__parameters:\n"
         "    type: 0                                        # keepout zones and preferred lanes\n"
         "    filter_info_topic: alignability_filter_info\n"
         "    mask_topic: alignability_mask\n"
         "    base: 0.0\n"
         "    multiplier: 1.0\n"
         "global_costmap:\n"
         "  global_costmap:\n"
         "    ros__parameters:\n"
         "      filters: [alignability_filter]               # beside those that are there\n"
         "      alignability_filter:\n"
         "        plugin: nav2_costmap_2d::KeepoutFilter\n"
         "        enabled: true\n"
         "        filter_info_topic: alignability_filter_info\n"
         "planner_server:\n"
         "  ros__parameters:\n"
         "    planner_plugins: [GridBased]\n"
         "    GridBased:\n"
         "      plugin: nav2_smac_planner::SmacPlanner2D     # nav2_smac_planner/SmacPlanner2D in ROS 2 Iron and before\n"
         "      cost_travel_multiplier: " +
         fixed_text(weight * most * kCostOfOne / kMostCostOfMask, 3) + "                # a metre costs 1 + " + to_text(weight) +
         " x risk\n";
}

// Tells which files it has written.
std::vector<std::filesystem::path> write_all(const Options& options, const PlanProblem& problem) {
  const std::filesystem::path name = output_name(options.output);
  const RiskField risk(at_the_worst_heading(problem.alignability), problem.occupancy, problem.query.risk);
  std::vector<std::filesystem::path> files;
  const auto write = [&](const std::string& ending, const std::string& text) {
    files.push_back(with_ending(name, ending));
    write_file(files.back(), text);
  };
  const std::filesystem::path mask = with_ending(name, "_mask");
  write_cost_mask(shares(risk, problem.occupancy), mask);
  for (const char* ending : {"_mask.yaml", "_mask.pgm"}) files.push_back(with_ending(name, ending));
  write("_nav2.yaml", nav2_parameters(with_ending(mask, ".yaml").filename(), problem.query.weight, most_risk(risk)));
  write("_cells.csv", to_csv(problem.alignability));
  write_alignability_map(problem.alignability, with_ending(name, "_map"));
  for (const char* ending : {"_map.yaml", "_map.tiff"}) files.push_back(with_ending(name, ending));
  write("_map.tfw", world_file(problem.alignability.geometry));
  for (const DrivenPath& path : read_paths(options.paths)) {
    write("_path_" + path.name + ".yaml", to_nav_path(path.path));
    write("_path_" + path.name + ".geojson", to_geojson(path.path, path.name));
  }
  return files;
}

int run(const Options& options) {
  const std::vector<std::filesystem::path> files = write_all(options, load(options.problem));
  if (options.json) {
    Json names = Json::array();
    for (const std::filesystem::path& file : files) names.push_back(file.string());
    print({{{"files", names}}});
  } else {
    for (const std::filesystem::path& file : files) std::cout << "wrote " << file.string() << '\n';
  }
  return kYes;
}

}  // namespace

void add_export(CLI::App& app, Work& work) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("export", "Write a problem's risk, its alignability map and paths for other programs");
  command->add_option("problem", options->problem.file, "Problem file")->type_name("YAML")->required();
  command->add_option("paths", options->paths, "Paths (CSV), as plan and compare write them")->type_name("CSV");
  command->add_option("--map", options->problem.map, "Occupancy map in place of the problem's")->type_name("YAML");
  command->add_option("--alignability", options->problem.alignability, "Alignability map in place of the problem's")->type_name("YAML");
  command->add_option("--weight", options->problem.weight, "Weight of the risk in place of the problem's")->check(CLI::NonNegativeNumber);
  command->add_flag("--json", options->json, "Print JSON");
  command
      ->add_option(
          "-o,--output", options->output,
          "NAME: writes NAME_mask.yaml and .pgm, a filter mask for nav2, NAME_nav2.yaml, the parameters that go with it, NAME_cells.csv, "
          "NAME_map.yaml, .tiff and .tfw, the map with a world file, and of each path NAME_path_PATH.yaml (nav_msgs/Path) and "
          ".geojson")
      ->type_name("NAME")
      ->required();
  command->footer(
      "Examples:\n"
      "  alignability export maps/warehouse/problem.yaml -o warehouse\n"
      "  alignability compare maps/warehouse/problem.yaml -o c\n"
      "  alignability export maps/warehouse/problem.yaml c_risk_aware.csv -o warehouse");
  command->callback([options, &work] { work = [options] { return run(*options); }; });
}

}  // namespace alignability::cli
