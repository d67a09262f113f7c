// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <iostream>

#include "cli/command.hpp"
#include "cli/interrupt.hpp"
#include "cli/json.hpp"
#include "cli/output_name.hpp"
#include "cli/path_output.hpp"
#include "cli/picture_option.hpp"
#include "cli/plan_stations.hpp"
#include "cli/problem_options.hpp"
#include "core/file.hpp"
#include "core/progress.hpp"
#include "localization/drive_file.hpp"

namespace alignability::cli {
namespace {

struct Options {
  ProblemOptions problem;
  bool json = false;
  std::optional<double> max_error;
  std::optional<double> max_blind_distance;
  std::optional<double> recovery_distance;
  std::optional<double> min_alignability;
  std::optional<std::filesystem::path> stations;
  std::optional<std::filesystem::path> output;
  PictureKinds pictures;
};

void write_files(const PlanProblem& problem, const RiskField& risk, const PlanResult& result, const Options& options) {
  const std::filesystem::path name = output_name(*options.output);
  if (result.status == PlanStatus::solved) {
    const DrawnPath path = drawn(result, risk, result.query.planner.name, kRiskAwareColour, LineStyle::solid);
    write_path_csv(result, risk, with_ending(name, ".csv"));
    const PathPictureOptions picture = picture_options(problem.query, risk, problem.occupancy.geometry(), name.filename().string());
    for (const auto& file : picture_files(name, options.pictures)) {
      draw_paths(problem.alignability, problem.occupancy, {&path, 1}, picture, file);
    }
  }
  write_file(with_ending(name, ".json"), plan_json(result).dump(2) + '\n');
}

// Where the map's error model was fitted for something else than the problem names.
void warn_of_mismatches(const ProblemFile& file, const AlignabilityMap& map) {
  Calibration used = map.error_model->calibration;
  if (file.sensor) {
    const SensorRig sensor = read_sensor_rig(*file.sensor);
    used.sensor = sensor.name;
    used.noise = sensor.range_stddev();
    used.range_max = file.range_max;
  }
  if (file.drive) {
    const DriveOptions drive = read_drive_file(*file.drive);
    used.localizer = to_string(drive.localizers.front());
    used.scale_bias = drive.odometry.scale_bias;
  }
  for (const std::string& mismatch : mismatches(map.error_model->calibration, used)) {
    std::cerr << "warning: " << file.alignability.front().string() << ": the error model was " << mismatch << '\n';
  }
}

// Of the certified bound. Where the start is in the goal both are 0.
double percent_above(const PlanResult& result) {
  const double bound = result.lower_bound.value_or(0.0);
  return result.cost > bound ? 100.0 * (result.cost / bound - 1.0) : 0.0;
}

void print_result(const PlanResult& result) {
  std::printf("%s, weight %g, %.2f s\n", result.query.planner.name.c_str(), result.query.weight, result.seconds);
  std::printf("%-20s %9.2f m, at most %.1f %% above the optimum\n", "cost", result.cost, percent_above(result));
  print_figures(result.figures, result.query.risk);
  if (result.longest_unrecovered) std::printf("%-20s %9.2f m\n", "longest unrecovered", *result.longest_unrecovered);
  if (result.predicted_error) std::printf("%-20s %9.2f m, 95 %% of the time\n", "predicted error", *result.predicted_error);
}

void set_limits(const Options& options, PlanQuery& query) {
  if (options.max_error) query.max_error = options.max_error;
  if (options.max_blind_distance) query.max_blind_distance = options.max_blind_distance;
  if (options.recovery_distance) query.recovery_distance = *options.recovery_distance;
  if (options.min_alignability) query.risk.min_alpha = options.min_alignability;
}

int run(const Options& options) {
  const Interrupt interrupt;
  ProblemFile file = problem_file(options.problem);
  set_limits(options, file.query);
  const PlanProblem problem = load_problem(file);
  if (options.stations)
    return plan_stations(problem, {*options.stations, options.json, options.output, options.pictures}, interrupt.token());
  if (problem.alignability.error_model) warn_of_mismatches(file, problem.alignability);
  const PlanningFields fields(problem);
  const PlanResult result = plan(problem.query, fields, {.stop = interrupt.token()});
  if (result.status == PlanStatus::interrupted) throw Interrupted();
  if (options.output) write_files(problem, *fields.risk, result, options);
  if (options.json) print({plan_json(result)});
  if (result.status != PlanStatus::solved) return say_no(options.problem.file, result);
  if (!options.json) print_result(result);
  return kYes;
}

}  // namespace

void add_plan(CLI::App& app, Work& work) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("plan", "Plan a path on which the robot stays localized");
  add_problem_options(*command, options->problem);
  command
      ->add_option(
          "--max-error", options->max_error,
          "The error of localization [m] that may be predicted anywhere on the path, 95th percentile; for a map with an error model")
      ->check(CLI::PositiveNumber);
  command
      ->add_option("--max-blind-distance", options->max_blind_distance,
                   "Blind metres that there may be between one place where the robot finds itself and the next")
      ->check(CLI::NonNegativeNumber);
  command
      ->add_option("--recovery-distance", options->recovery_distance,
                   "Safe metres without a break on which it finds itself, for --max-blind-distance (1 unless the file says)")
      ->check(CLI::PositiveNumber);
  command->add_option("--min-alignability", options->min_alignability, "Places whose alignability is less, or unknown, are shut")
      ->check(CLI::Range(0.0, 1.0));
  command
      ->add_option("--stations", options->stations,
                   "File that names stations: plan from each to each instead of from start to goal, with the planner field, and give "
                   "the matrix of costs")
      ->type_name("YAML");
  command->add_flag("--json", options->json, "Print JSON");
  command->add_option("-o,--output", options->output, "NAME: writes NAME.json, NAME.csv and NAME.png; with --stations those of all ways")
      ->type_name("NAME");
  add_picture_option(*command, options->pictures);
  command->footer(
      "Examples:\n"
      "  alignability plan maps/warehouse/problem.yaml -o route\n"
      "  alignability plan maps/warehouse/problem.yaml --alignability calibrated.yaml --max-error 0.15\n"
      "  alignability plan maps/warehouse/problem.yaml --weight 0 --max-blind-distance 10\n"
      "  alignability plan maps/warehouse/problem.yaml --stations maps/warehouse/stations.yaml -o ways\n"
      "  alignability plan maps/warehouse/problem.yaml --planner prmstar --time 10 --weight 2 --json");
  command->callback([options, &work] { work = [options] { return run(*options); }; });
}

}  // namespace alignability::cli
