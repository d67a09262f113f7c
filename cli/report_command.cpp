// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>

#include "cli/command.hpp"
#include "cli/drive_paths.hpp"
#include "cli/drive_site.hpp"
#include "cli/interrupt.hpp"
#include "cli/path_output.hpp"
#include "cli/problem_options.hpp"
#include "cli/report_output.hpp"
#include "core/file.hpp"

namespace alignability::cli {
namespace {

struct Options {
  ProblemOptions problem;
  std::vector<std::filesystem::path> paths;
  std::optional<int> drives;  // a path
  DriveSiteOptions drive;
  std::filesystem::path output;
};

ReportedPath reported(const DrivenPath& path, const RiskField& risk, std::size_t number) {
  return {.name = path.name,
          .samples = sample(path.path, risk, kPathStep),
          .figures = measure(path.path, risk),
          .colour = route_colour(number),
          .style = number == 0 ? LineStyle::dashed : LineStyle::solid};
}

std::vector<ReportedPath> reported_paths(const Options& options, const PlanProblem& problem, const PlanningFields& fields) {
  const Interrupt interrupt;
  std::vector<DrivenPath> paths = read_paths(options.paths);
  std::vector<ReportedPath> reports;
  for (const DrivenPath& path : paths) reports.push_back(reported(path, *fields.risk, reports.size()));
  if (!options.drives || paths.empty()) return reports;
  const DriveSite site =
      load_drive_site(problem_file(options.problem), options.problem.file, problem.occupancy, options.drive, interrupt.token());
  TrialOptions trials = site.trials;
  trials.runs = *options.drives;
  paths = driven(std::move(paths), site, trials);
  const double radius = circumscribed_radius(problem.query.robot);
  for (std::size_t i = 0; i < paths.size(); ++i) {
    for (std::size_t k = 0; k < trials.drive.localizers.size(); ++k) {
      reports[i].errors.push_back(
          reported_errors(errors_of(paths[i], k, *fields.clearance, radius), trials.drive.localizers[k], trials.runs));
    }
  }
  return reports;
}

int run(const Options& options, const std::string& command_line) {
  const PlanProblem problem = load(options.problem);
  const PlanningFields fields(problem);
  Report report{.title = options.output.stem().string(),
                .summary = {},
                .command = command_line,
                .paths = reported_paths(options, problem, fields),
                .options = reported_options(problem)};
  write_file(options.output, to_html(report, problem, *fields.risk));
  std::cout << "wrote " << options.output.string() << '\n';
  return kYes;
}

}  // namespace

void add_report(CLI::App& app, Work& work, const std::string& command_line) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("report", "Show a problem's maps and paths on a page for the browser");
  command->add_option("problem", options->problem.file, "Problem file")->type_name("YAML")->required();
  command->add_option("paths", options->paths, "Paths (CSV), as plan and compare write them")->type_name("CSV");
  command->add_option("--map", options->problem.map, "Occupancy map in place of the problem's")->type_name("YAML");
  command->add_option("--alignability", options->problem.alignability, "Alignability map in place of the problem's")->type_name("YAML");
  CLI::Option* drives =
      command->add_option("--drive", options->drives, "Drive each path that many times, and show how far off a localizer is along it")
          ->check(CLI::Range(1, 100'000));
  for (CLI::Option* option : add_drive_options(*command, options->drive)) option->needs(drives);
  command->add_option("-o,--output", options->output, "The HTML file, which holds all it shows")->type_name("FILE")->required();
  command->footer(
      "Examples:\n"
      "  alignability report maps/warehouse/problem.yaml -o warehouse.html\n"
      "  alignability compare maps/warehouse/problem.yaml -o c\n"
      "  alignability report maps/warehouse/problem.yaml c_shortest.csv c_risk_aware.csv --drive 10 -o driven.html");
  command->callback([options, &work, command_line] { work = [options, command_line] { return run(*options, command_line); }; });
}

}  // namespace alignability::cli
