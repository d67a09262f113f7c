// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <iostream>

#include "cli/command.hpp"
#include "cli/drive_paths.hpp"
#include "cli/interrupt.hpp"
#include "cli/json.hpp"
#include "cli/output_name.hpp"
#include "cli/problem_options.hpp"
#include "localization/fit_error_model.hpp"

namespace alignability::cli {
namespace {

struct Options {
  ProblemOptions problem;
  DriveSiteOptions drive;
  std::vector<std::filesystem::path> paths;
  std::vector<std::filesystem::path> held_out;
  int runs = 20;
  bool json = false;
  std::filesystem::path output;
};

Json model_json(const ErrorModel& model) {
  return {{"growth", model.growth},         {"recovery", model.recovery},     {"least", model.least},
          {"alpha_poor", model.alpha_poor}, {"alpha_rich", model.alpha_rich}, {"localizer", model.calibration.localizer}};
}

Json check_json(const DrivenPath& path, bool held_out, const std::optional<ErrorModelCheck>& check) {
  return {{"name", path.name},
          {"held_out", held_out},
          {"rms", check ? Json(check->rms) : Json(nullptr)},
          {"covered", check ? Json(check->covered) : Json(nullptr)}};
}

void print_summary(const Json& summary) {
  const Json& model = summary["model"];
  std::printf(
      "The 95th percentile of the error grows by %.4f m a metre where alpha is at most %g, and where it is at least %g\n"
      "what exceeds %.3f m shrinks to 1/e within %.1f m.\n\n",
      model["growth"].get<double>(), model["alpha_poor"].get<double>(), model["alpha_rich"].get<double>(), model["least"].get<double>(),
      model["recovery"].get<double>());
  std::printf("%-24s %14s %10s\n", "", "off by (rms)", "covered");
  for (const Json& path : summary["paths"]) {
    const std::string name = path["name"];
    if (path["rms"].is_null()) {
      std::printf("%-24s too short\n", name.c_str());
      continue;
    }
    std::printf("%-24s %12.3f m %8.1f %%  %s\n", name.c_str(), path["rms"].get<double>(), 100.0 * path["covered"].get<double>(),
                path["held_out"].get<bool>() ? "held out" : "");
  }
}

int run(const Options& options) {
  const Interrupt interrupt;
  const ProblemFile file = problem_file(options.problem);
  const PlanProblem problem = load_problem(file);
  const RiskField risk(problem.alignability, problem.occupancy, problem.query.risk);
  std::vector<DrivenPath> paths = read_paths(options.paths);
  if (const auto refusal = refusal_of_fit(paths, risk)) throw std::invalid_argument(*refusal);
  for (DrivenPath& path : read_paths(options.held_out)) paths.push_back(std::move(path));
  warn_of_collisions(paths, ClearanceMap(problem.occupancy), inscribed_radius(problem.query.robot));
  const DriveSite site = load_drive_site(file, options.problem.file, problem.occupancy, options.drive, interrupt.token());
  if (site.trials.drive.localizers.size() > 1) throw std::invalid_argument("an error model is one localizer's: name it by --localizer");
  TrialOptions trials = site.trials;
  trials.runs = options.runs;
  paths = driven(std::move(paths), site, trials);
  AlignabilityMap map = problem.alignability;
  ErrorModel model = fit_error_model(std::span(paths).first(options.paths.size()), 0, risk);
  model.calibration = calibration_of(trials.drive, 0, site.lidar, file.range_max);
  map.error_model = model;
  Json summary{{"model", model_json(model)}, {"runs", options.runs}, {"paths", Json::array()}};
  for (std::size_t i = 0; i < paths.size(); ++i) {
    summary["paths"].push_back(check_json(paths[i], i >= options.paths.size(), check_error_model(model, paths[i], 0, risk)));
  }
  const std::filesystem::path name = output_name(options.output);
  write_alignability_map(map, name);
  if (options.json) {
    print({summary});
  } else {
    print_summary(summary);
    std::cout << "\nwrote " << with_ending(name, ".yaml").string() << '\n';
  }
  return kYes;
}

}  // namespace

void add_calibrate(CLI::App& app, Work& work) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("calibrate", "Fit how far off a localizer is to how alignable its way was, for plan --max-error");
  command->add_option("problem", options->problem.file, "Problem file that names scene, sensor and drive")->required();
  command->add_option("paths", options->paths, "Paths (CSV) to drive and to fit the model to; blind stretches and rich ones")->required();
  command->add_option("--held-out", options->held_out, "Further paths, driven to see how the model fares where it was not fitted");
  command->add_option("--map", options->problem.map, "Occupancy map in place of the problem's");
  command->add_option("--alignability", options->problem.alignability, "Alignability map in place of the problem's");
  command->add_option("--runs", options->runs, "Drives of each path")->check(CLI::Range(1, 100'000))->capture_default_str();
  add_drive_options(*command, options->drive);
  command->add_flag("--json", options->json, "Print JSON");
  command->add_option("-o,--output", options->output, "NAME: writes the alignability map with its error model, NAME.yaml and NAME.tiff")
      ->required();
  command->footer(
      "Examples:\n"
      "  alignability calibrate maps/warehouse/problem.yaml c_shortest.csv c_risk_aware.csv -o calibrated\n"
      "  alignability calibrate maps/warehouse/problem.yaml a.csv --held-out b.csv --localizer ndt_mcl_product -o calibrated");
  command->callback([options, &work] { work = [options] { return run(*options); }; });
}

}  // namespace alignability::cli
