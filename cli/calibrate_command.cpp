// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstdio>
#include <iostream>

#include "cli/command.hpp"
#include "cli/drive_paths.hpp"
#include "cli/interrupt.hpp"
#include "cli/json.hpp"
#include "cli/output_name.hpp"
#include "cli/problem_options.hpp"
#include "core/input_error.hpp"
#include "localization/fit_error_model.hpp"

namespace alignability::cli {
namespace {

struct Options {
  ProblemOptions problem;
  DriveSiteOptions drive;
  std::vector<std::filesystem::path> paths;     // each after the problem of its site, or the first's
  std::vector<std::filesystem::path> held_out;  // likewise
  int runs = 20;
  bool json = false;
  std::filesystem::path output;
};

// Where paths are driven, and which.
struct Site {
  explicit Site(const ProblemOptions& options)
      : problem_file(options.file),
        file(cli::problem_file(options)),
        problem(load_problem(file)),
        risk(problem.alignability, problem.occupancy, problem.query.risk) {}

  std::filesystem::path problem_file;
  ProblemFile file;
  PlanProblem problem;
  RiskField risk;
  std::vector<DrivenPath> fitted;
  std::vector<DrivenPath> held_out;
};

std::vector<std::unique_ptr<Site>> sites_of(const Options& options) {
  std::vector<std::unique_ptr<Site>> sites;
  sites.push_back(std::make_unique<Site>(options.problem));
  const auto site_of = [&](const std::filesystem::path& problem) -> Site& {
    const auto known = std::ranges::find(sites, problem, [](const auto& site) { return site->problem_file; });
    if (known != sites.end()) return **known;
    ProblemOptions named;
    named.file = problem;
    sites.push_back(std::make_unique<Site>(named));
    return *sites.back();
  };
  const auto add = [&](const std::vector<std::filesystem::path>& files, std::vector<DrivenPath> Site::*paths) {
    Site* site = sites.front().get();
    for (const std::filesystem::path& file : files) {
      if (file.extension() == ".yaml" || file.extension() == ".yml") {
        site = &site_of(file);
      } else {
        (site->*paths).push_back(std::move(read_paths({&file, 1}).front()));
      }
    }
  };
  add(options.paths, &Site::fitted);
  add(options.held_out, &Site::held_out);
  return sites;
}

Json model_json(const ErrorModel& model) {
  return {{"growth", model.growth},         {"recovery", model.recovery},     {"least", model.least},
          {"alpha_poor", model.alpha_poor}, {"alpha_rich", model.alpha_rich}, {"localizer", model.calibration.localizer}};
}

Json checks_json(const std::vector<std::unique_ptr<Site>>& sites, const ErrorModel& model) {
  Json checks = Json::array();
  const auto add = [&](const Site& site, const DrivenPath& path, bool held_out) {
    const auto check = check_error_model(model, path, 0, site.risk);
    checks.push_back({{"problem", site.problem_file.string()},
                      {"name", path.name},
                      {"held_out", held_out},
                      {"rms", check ? Json(check->rms) : Json(nullptr)},
                      {"covered", check ? Json(check->covered) : Json(nullptr)}});
  };
  for (const auto& site : sites) {
    for (const DrivenPath& path : site->fitted) add(*site, path, false);
    for (const DrivenPath& path : site->held_out) add(*site, path, true);
  }
  return checks;
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

// For what a site's drives tell. Throws where the model of the first site would not be for those of another.
Calibration checked_calibration(const std::vector<std::unique_ptr<Site>>& sites, const DriveSiteOptions& options) {
  std::optional<Calibration> first;
  for (const auto& site : sites) {
    const DriveOptions drive = drive_options_of(site->file, site->problem_file, options);
    if (drive.localizers.size() > 1) throw std::invalid_argument("an error model is one localizer's: name it by --localizer");
    const SensorRig sensor = sensor_of(site->file, site->problem_file, options);
    const Calibration calibration = calibration_of(drive, 0, sensor, site->file.range_max);
    if (!first) first = calibration;
    const std::vector<std::string> differences = mismatches(*first, calibration);
    if (!differences.empty())
      throw InputError(site->problem_file, "an error model is for one way of driving: " + differences.front() + " here");
  }
  return *first;
}

void drive(Site& site, const Options& options, const std::stop_token& stop) {
  const ClearanceMap clearance(site.problem.occupancy);
  const double radius = inscribed_radius(site.problem.query.robot);
  warn_of_collisions(site.fitted, clearance, radius);
  warn_of_collisions(site.held_out, clearance, radius);
  const DriveSite place = load_drive_site(site.file, site.problem_file, site.problem.occupancy, options.drive, stop);
  TrialOptions trials = place.trials;
  trials.runs = options.runs;
  if (!site.fitted.empty()) site.fitted = driven(std::move(site.fitted), place, trials);
  if (!site.held_out.empty()) site.held_out = driven(std::move(site.held_out), place, trials);
}

std::vector<SitePaths> fitted_on(const std::vector<std::unique_ptr<Site>>& sites) {
  std::vector<SitePaths> fitted;
  for (const auto& site : sites) fitted.push_back({site->fitted, site->risk});
  return fitted;
}

int run(const Options& options) {
  const Interrupt interrupt;
  const std::vector<std::unique_ptr<Site>> sites = sites_of(options);
  if (const auto refusal = refusal_of_fit(fitted_on(sites))) throw std::invalid_argument(*refusal);
  const Calibration calibration = checked_calibration(sites, options.drive);
  for (const auto& site : sites) drive(*site, options, interrupt.token());
  ErrorModel model = fit_error_model(fitted_on(sites), 0);
  model.calibration = calibration;
  AlignabilityMap map = sites.front()->problem.alignability;
  map.error_model = model;
  const Json summary{{"model", model_json(model)}, {"runs", options.runs}, {"paths", checks_json(sites, model)}};
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
  command->add_option("problem", options->problem.file, "Problem file that names scene, sensor and drive")->type_name("YAML")->required();
  command
      ->add_option("paths", options->paths,
                   "Paths (CSV) to drive and to fit the model to, blind stretches and rich ones; of another site after its problem file")
      ->type_name("FILE")
      ->required();
  command->add_option("--held-out", options->held_out, "Further paths, likewise, driven to see how the model fares where it was not fitted")
      ->type_name("FILE");
  command->add_option("--map", options->problem.map, "Occupancy map in place of the problem's")->type_name("YAML");
  command->add_option("--alignability", options->problem.alignability, "Alignability map in place of the problem's")->type_name("YAML");
  command->add_option("--runs", options->runs, "Drives of each path")->check(CLI::Range(1, 100'000))->capture_default_str();
  add_drive_options(*command, options->drive);
  command->add_flag("--json", options->json, "Print JSON");
  command->add_option("-o,--output", options->output, "NAME: writes the alignability map with its error model, NAME.yaml and NAME.tiff")
      ->type_name("NAME")
      ->required();
  command->footer(
      "Examples:\n"
      "  alignability calibrate maps/warehouse/problem.yaml c_shortest.csv c_risk_aware.csv -o calibrated\n"
      "  alignability calibrate maps/warehouse/problem.yaml a.csv --held-out b.csv --localizer ndt_mcl_product -o calibrated\n"
      "  alignability calibrate hall.yaml a.csv --held-out office.yaml b.csv c.csv -o calibrated");
  command->callback([options, &work] { work = [options] { return run(*options); }; });
}

}  // namespace alignability::cli
