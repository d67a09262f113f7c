// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <iostream>

#include "cli/command.hpp"
#include "cli/evaluate_output.hpp"
#include "cli/output_name.hpp"
#include "cli/picture_option.hpp"
#include "cli/problem_options.hpp"
#include "planner/route_file.hpp"

namespace alignability::cli {
namespace {

struct Options {
  std::filesystem::path route;
  RouteFileOptions file;
  std::vector<std::string> nodes;
  ProblemOptions problem;
  bool json = false;
  std::optional<std::filesystem::path> output;
  PictureKinds pictures;
};

Route read(const Options& options) {
  Route route = read_route(options.route, options.file);
  for (const std::string& remark : route.remarks) std::cerr << options.route.string() << ": " << remark << '\n';
  if (options.nodes.empty()) return route;
  if (route.graph.edges.empty()) throw std::invalid_argument("--nodes chooses from a graph, and " + options.route.string() + " is a path");
  return {.path = path_along(route.graph, options.nodes), .graph = {}, .remarks = {}};
}

int say_no(const Options& options, const Evaluation& evaluation) {
  std::cerr << options.route.string() << ": ";
  if (!evaluation.edges.empty()) {
    const auto obstructed =
        std::ranges::count_if(evaluation.edges, [](const EdgeEvaluation& edge) { return edge.way.obstruction.has_value(); });
    std::cerr << obstructed << " of " << evaluation.edges.size() << " edges obstructed; edge " << evaluation.edges.front().edge.id << ": ";
  }
  std::cerr << obstruction_text(evaluation.total) << '\n';
  return kNo;
}

int run(const Options& options) {
  EvaluatedRoute evaluated{.route = read(options), .problem = load(options.problem), .evaluation = {}};
  const PlanningFields fields(evaluated.problem);
  evaluated.evaluation = evaluate(evaluated.route, evaluated.problem.query, fields);
  if (options.output) write_evaluation(evaluated, *fields.risk, output_name(*options.output), options.pictures);
  if (options.json) {
    print({evaluation_json(evaluated)});
  } else {
    print_evaluation(evaluated);
  }
  return evaluated.evaluation.total.obstruction ? say_no(options, evaluated.evaluation) : kYes;
}

}  // namespace

void add_evaluate(CLI::App& app, Work& work) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("evaluate", "Score a route or lanes that exist, as a planned path is scored");
  command->add_option("route", options->route, "A path (CSV), a nav2 route graph (GeoJSON) or a VDA 5050 layout (LIF)")
      ->type_name("FILE")
      ->required();
  command->add_option("--problem", options->problem.file, "Problem file: maps, robot and risk are taken from it")
      ->type_name("YAML")
      ->required();
  command->add_option("--map", options->problem.map, "Occupancy map in place of the problem's")->type_name("YAML");
  command->add_option("--alignability", options->problem.alignability, "Alignability map in place of the problem's")->type_name("YAML");
  command->add_option("--weight", options->problem.weight, "Weight of the risk in the cost")->check(CLI::NonNegativeNumber);
  command->add_option("--nodes", options->nodes, "Score the path along these nodes of a graph: 3,7,12")->type_name("NODE")->delimiter(',');
  command->add_option("--vehicle", options->file.vehicle, "Vehicle type of a LIF file, where they drive differently")->type_name("TYPE");
  command->add_option("--map-id", options->file.map, "Map of a LIF file, where it has several")->type_name("ID");
  command->add_flag("--json", options->json, "Print JSON");
  command->add_option("-o,--output", options->output, "NAME: writes NAME.json, NAME.csv and NAME.png")->type_name("NAME");
  add_picture_option(*command, options->pictures);
  command->footer(
      "Examples:\n"
      "  alignability evaluate maps/warehouse/lanes.geojson --problem maps/warehouse/problem.yaml -o lanes\n"
      "  alignability evaluate maps/warehouse/lanes.geojson --problem maps/warehouse/problem.yaml --nodes 1,2,3 --json");
  command->callback([options, &work] { work = [options] { return run(*options); }; });
}

}  // namespace alignability::cli
