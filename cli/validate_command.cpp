// SPDX-License-Identifier: BSD-3-Clause
#include "cli/command.hpp"
#include "cli/drive_paths.hpp"
#include "cli/drive_site.hpp"
#include "cli/interrupt.hpp"
#include "cli/output_name.hpp"
#include "cli/picture_option.hpp"
#include "cli/problem_options.hpp"
#include "cli/validate_log.hpp"
#include "cli/validate_output.hpp"
#include "cli/validate_pictures.hpp"
#include "core/file.hpp"
#include "core/progress.hpp"
#include "core/range.hpp"
#include "planner/headings.hpp"
#include "planner/plan.hpp"
#include "planner/planners.hpp"

namespace alignability::cli {
namespace {

struct Options {
  ProblemOptions problem;
  DriveSiteOptions drive;
  std::vector<double> waypoints;             // x, y, x, y, …
  std::vector<std::filesystem::path> paths;  // in place of waypoints
  int laps = 3;
  int runs = 10;
  bool json = false;
  std::optional<std::filesystem::path> output;
  PictureKinds pictures;
};

// The shortest way from one waypoint to the next, as a disk goes.
std::vector<Pose2> leg(PlanQuery query, const PlanningFields& fields, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                       const std::stop_token& stop) {
  query.robot = {.radius = circumscribed_radius(query.robot)};
  query.motion.space = MotionSpace::r2;
  query.weight = 0.0;
  query.max_error.reset();
  query.max_blind_distance.reset();
  query.planner.name = kDefaultPlanner;
  query.goal_tolerance.position = 1e-6;
  query.start = {from.x(), from.y(), 0.0};
  query.goal = {to.x(), to.y(), 0.0};
  const PlanResult result = plan(query, fields, {.stop = stop});
  if (result.status == PlanStatus::interrupted) throw Interrupted();
  if (result.status != PlanStatus::solved) {
    throw std::invalid_argument("--waypoints: no way from " + to_text(from.x()) + ',' + to_text(from.y()) + " to " + to_text(to.x()) + ',' +
                                to_text(to.y()) + ": " + to_string(result.status));
  }
  return result.path;
}

std::vector<Pose2> tour(const Options& options, const PlanQuery& query, const PlanningFields& fields, const std::stop_token& stop) {
  if (options.waypoints.size() % 2 != 0) throw std::invalid_argument("--waypoints: takes pairs of x,y");
  std::vector<Eigen::Vector2d> waypoints;
  for (std::size_t i = 0; i < options.waypoints.size(); i += 2) waypoints.emplace_back(options.waypoints[i], options.waypoints[i + 1]);
  if (waypoints.size() < 2) throw std::invalid_argument("--waypoints: takes at least two");
  std::vector<Pose2> lap;
  for (std::size_t i = 0; i < waypoints.size(); ++i) {
    const std::vector<Pose2> way = leg(query, fields, waypoints[i], waypoints[(i + 1) % waypoints.size()], stop);
    lap.insert(lap.end(), way.begin(), way.end());
  }
  std::vector<Pose2> path;
  for (int i = 0; i < options.laps; ++i) path.insert(path.end(), lap.begin(), lap.end());
  return turning_on_the_spot(looking_ahead(std::move(path), query.start.yaw));
}

int run(const Options& options) {
  const Interrupt interrupt;
  const ProblemFile file = problem_file(options.problem);
  const PlanProblem problem = load_problem(file);
  const PlanningFields fields(problem);
  std::vector<DrivenPath> paths = read_paths(options.paths);
  if (paths.empty()) {
    std::vector<Pose2> way = tour(options, problem.query, fields, interrupt.token());
    paths.push_back({"tour", std::move(way), {}});
  }
  warn_of_collisions(paths, *fields.clearance, inscribed_radius(problem.query.robot));
  const DriveSite site = load_drive_site(file, options.problem.file, problem.occupancy, options.drive, interrupt.token());
  TrialOptions trials = site.trials;
  trials.runs = options.runs;
  paths = driven(std::move(paths), site, trials);
  const ErrorReference reference{problem.alignability, *fields.clearance, circumscribed_radius(problem.query.robot)};
  const std::vector<Validation> validations = validate(paths, trials.drive.localizers, reference);
  std::vector<Json> summaries;
  for (const Validation& validation : validations) {
    summaries.push_back(validation_json(validation, paths, trials, problem.alignability.geometry));
  }
  if (options.output) {
    const std::filesystem::path name = output_name(*options.output);
    if (options.paths.empty()) {
      draw_error_maps(validations, problem, paths.front(), name, options.pictures);
    } else {
      draw_profiles(validations, paths, *fields.risk, name, options.pictures);
    }
    write_cells_csv(validations, problem.alignability, with_ending(name, ".csv"));
    write_file(with_ending(name, ".json"), (summaries.size() == 1 ? summaries.front() : Json(summaries)).dump(2) + '\n');
  }
  if (options.json) {
    print(summaries);
    return kYes;
  }
  for (const Validation& validation : validations) {
    print_errors(validation, paths);
    if (options.paths.empty()) print_predictions(validation);
  }
  return kYes;
}

void add_common_options(CLI::App& command, Options& options) {
  command.add_option("--map", options.problem.map, "Occupancy map in place of the problem's")->type_name("YAML");
  command.add_option("--alignability", options.problem.alignability, "Alignability map in place of the problem's")->type_name("YAML");
  command.add_option("--runs", options.runs, "Drives of each path, each with errors of its own, the same on every path")
      ->check(CLI::Range(1, 100'000))
      ->capture_default_str();
  add_drive_options(command, options.drive);
  command.add_flag("--json", options.json, "Print JSON");
}

void add_validate_map(CLI::App& validate, Work& work) {
  const auto options = std::make_shared<Options>();
  CLI::App* command =
      validate.add_subcommand("map", "Drive a tour, and hold the errors of localization against alignability, cell by cell");
  command->add_option("problem", options->problem.file, "Problem file that names scene, sensor and drive")->type_name("YAML")->required();
  command
      ->add_option("--waypoints", options->waypoints, "The tour's corners, joined by shortest paths, the last to the first: x,y x,y … [m]")
      ->delimiter(',')
      ->required();
  command->add_option("--laps", options->laps, "How often around")->check(CLI::Range(1, 1000))->capture_default_str();
  add_common_options(*command, *options);
  command
      ->add_option("-o,--output", options->output,
                   "NAME: writes NAME.json, NAME.csv, and of each localizer NAME_…_error.png and NAME_…_scatter.png")
      ->type_name("NAME");
  add_picture_option(*command, options->pictures);
  command->footer(
      "Example:\n"
      "  alignability validate map maps/warehouse/problem.yaml --waypoints 5,20 55,20 52,10 5,10 --runs 10 -o tour");
  command->callback([options, &work] { work = [options] { return run(*options); }; });
}

void add_validate_path(CLI::App& validate, Work& work) {
  const auto options = std::make_shared<Options>();
  options->runs = 20;
  CLI::App* command = validate.add_subcommand("path", "Drive paths, and tell how far off a localizer is along each");
  command->add_option("problem", options->problem.file, "Problem file that names scene, sensor and drive")->type_name("YAML")->required();
  command->add_option("paths", options->paths, "Paths (CSV), as plan and compare write them")->type_name("CSV")->required();
  add_common_options(*command, *options);
  command->add_option("-o,--output", options->output, "NAME: writes NAME.json, NAME.csv, and of each localizer NAME_….png")
      ->type_name("NAME");
  add_picture_option(*command, options->pictures);
  command->footer(
      "Example:\n"
      "  alignability compare maps/warehouse/problem.yaml -o c\n"
      "  alignability validate path maps/warehouse/problem.yaml c_shortest.csv c_risk_aware.csv --runs 20 -o driven");
  command->callback([options, &work] { work = [options] { return run(*options); }; });
}

}  // namespace

void add_validate(CLI::App& app, Work& work) {
  CLI::App* validate = app.add_subcommand("validate", "Drive a simulated localizer, and see where it gets lost");
  validate->require_subcommand(1);
  validate->footer(
      "Examples:\n"
      "  alignability validate map maps/warehouse/problem.yaml --waypoints 5,20 55,20 52,10 5,10 -o tour\n"
      "  alignability validate path maps/warehouse/problem.yaml c_shortest.csv c_risk_aware.csv -o driven");
  add_validate_map(*validate, work);
  add_validate_path(*validate, work);
  add_validate_log(*validate, work);
}

}  // namespace alignability::cli
