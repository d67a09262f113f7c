// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cstdio>

#include "cli/command.hpp"
#include "cli/interrupt.hpp"
#include "cli/json.hpp"
#include "cli/output_name.hpp"
#include "cli/path_output.hpp"
#include "cli/problem_options.hpp"
#include "core/file.hpp"
#include "core/progress.hpp"

namespace alignability::cli {
namespace {

struct Options {
  ProblemOptions problem;
  bool json = false;
  std::optional<std::filesystem::path> output;
};

void write_files(const PlanProblem& problem, const RiskField& risk, const Comparison& comparison, const std::filesystem::path& name) {
  if (solved(comparison)) {
    const std::array paths{drawn(comparison.risk_aware, risk, "risk-aware", kRiskAwareColour, LineStyle::solid),
                           drawn(comparison.shortest, risk, "shortest", kShortestColour, LineStyle::dashed)};
    write_path_csv(comparison.shortest, risk, with_ending(name, "_shortest.csv"));
    write_path_csv(comparison.risk_aware, risk, with_ending(name, "_risk_aware.csv"));
    draw_paths(problem.alignability, problem.occupancy, paths, picture_options(problem.query, name.filename().string()),
               with_ending(name, ".png"));
  }
  write_file(with_ending(name, ".json"), compare_json(comparison).dump(2) + '\n');
}

void print_row(const char* name, double shortest, double risk_aware, const char* unit) {
  char relative[32] = "";
  if (shortest > 0.0) std::snprintf(relative, sizeof relative, "%6.2f x", risk_aware / shortest);
  std::printf("%-18s %10.2f %-2s %10.2f %-2s %10s\n", name, shortest, unit, risk_aware, unit, relative);
}

void print_table(const Comparison& comparison) {
  const PathFigures& a = comparison.shortest.figures;
  const PathFigures& b = comparison.risk_aware.figures;
  std::printf("%-18s %10s    %10s    %10s\n", "", "shortest", "risk-aware", "relative");
  print_row("length", a.length, b.length, "m");
  print_row("blind", a.blind_length, b.blind_length, "m");
  print_row("longest blind", a.longest_blind, b.longest_blind, "m");
  print_row("risk integral", a.risk_integral, b.risk_integral, "m");
  print_row("alpha, mean", a.alpha_mean, b.alpha_mean, "");
  print_row("alpha, least", a.alpha_min, b.alpha_min, "");
  print_row("planning", comparison.shortest.seconds, comparison.risk_aware.seconds, "s");
}

int run(const Options& options) {
  const Interrupt interrupt;
  const PlanProblem problem = load(options.problem);
  const PlanningFields fields(problem);
  const Comparison comparison = compare(problem.query, fields, {.stop = interrupt.token()});
  if (interrupt.token().stop_requested()) throw Interrupted();
  if (options.output) write_files(problem, *fields.risk, comparison, output_name(*options.output));
  if (options.json) print({compare_json(comparison)});
  if (!solved(comparison)) {
    const PlanResult& failed = comparison.shortest.status != PlanStatus::solved ? comparison.shortest : comparison.risk_aware;
    return say_no(options.problem.file, failed);
  }
  if (!options.json) print_table(comparison);
  return kYes;
}

}  // namespace

void add_compare(CLI::App& app, Work& work) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("compare", "Plan the shortest and the risk-aware path, and put them side by side");
  add_problem_options(*command, options->problem);
  command->add_flag("--json", options->json, "Print JSON");
  command->add_option("-o,--output", options->output, "NAME: writes NAME.json, NAME.png, NAME_shortest.csv and NAME_risk_aware.csv");
  command->footer(
      "Examples:\n"
      "  alignability compare maps/warehouse/problem.yaml -o comparison\n"
      "  alignability compare maps/warehouse/problem.yaml --weight 10 --time 10 --json");
  command->callback([options, &work] { work = [options] { return run(*options); }; });
}

}  // namespace alignability::cli
