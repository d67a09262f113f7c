// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <functional>
#include <set>
#include <span>
#include <vector>

#include "cli/command.hpp"
#include "cli/compare_drive.hpp"
#include "cli/compare_output.hpp"
#include "cli/drive_site.hpp"
#include "cli/interrupt.hpp"
#include "cli/json.hpp"
#include "cli/output_name.hpp"
#include "cli/path_output.hpp"
#include "cli/picture_option.hpp"
#include "cli/problem_options.hpp"
#include "cli/progress_bar.hpp"
#include "cli/report_output.hpp"
#include "core/file.hpp"
#include "core/progress.hpp"
#include "planner/trade_off.hpp"

namespace alignability::cli {
namespace {

// With --pairs, so many of them are driven.
constexpr std::size_t kDrivenPairs = 10;

struct Options {
  ProblemOptions problem;
  std::vector<double> weights;
  std::vector<double> blind_limits;
  std::optional<std::size_t> pairs;
  std::optional<int> drives;  // a path
  DriveSiteOptions drive;
  bool json = false;
  std::optional<std::filesystem::path> output;
  PictureKinds pictures;
  std::optional<std::filesystem::path> html;
  std::string command_line;  // for the page
};

void write_paths(const PlanProblem& problem, const RiskField& risk, const Comparison& comparison, const std::filesystem::path& name,
                 const PictureKinds& kinds) {
  if (!solved(comparison)) return;
  const std::array paths{drawn(comparison.risk_aware, risk, "risk-aware", kRiskAwareColour, LineStyle::solid),
                         drawn(comparison.shortest, risk, "shortest", kShortestColour, LineStyle::dashed)};
  write_path_csv(comparison.shortest, risk, with_ending(name, "_shortest.csv"));
  write_path_csv(comparison.risk_aware, risk, with_ending(name, "_risk_aware.csv"));
  const PathPictureOptions picture = picture_options(problem.query, risk, problem.occupancy.geometry(), name.filename().string());
  for (const auto& file : picture_files(name, kinds)) draw_paths(problem.alignability, problem.occupancy, paths, picture, file);
}

void write_page(const Options& options, const PlanProblem& problem, const RiskField& risk, const Comparison& comparison,
                std::span<const DrivenComparison> driven, std::span<const PlanResult> further) {
  const Report report{.title = options.html->stem().string(),
                      .summary = summary_of(comparison),
                      .command = options.command_line,
                      .paths = reported(comparison, driven, options.drives.value_or(0), further, risk),
                      .options = reported_options(problem)};
  write_file(*options.html, to_html(report, problem, risk));
}

// Where paths are to be driven.
std::optional<DriveSite> drive_site(const Options& options, const OccupancyMap& occupancy, const Interrupt& interrupt) {
  if (!options.drives) return std::nullopt;
  return load_drive_site(problem_file(options.problem), options.problem.file, occupancy, options.drive, interrupt.token());
}

PlanOptions plan_options(const Interrupt& interrupt) { return {.stop = interrupt.token()}; }

// Those asked for, that of the problem, and 0 for the shortest path.
std::set<double> all_weights(const Options& options, const PlanQuery& query) {
  std::set<double> weights(options.weights.begin(), options.weights.end());
  weights.insert({0.0, query.weight});
  return weights;
}

// From the loosest down.
std::vector<PlanResult> within_blind_limits(const Options& options, const PlanQuery& query, const PlanningFields& fields,
                                            std::span<const PlanResult> known, const Interrupt& interrupt) {
  const std::set<double, std::greater<>> limits(options.blind_limits.begin(), options.blind_limits.end());
  return blind_trade_off(query, fields, std::vector<double>(limits.begin(), limits.end()), known, plan_options(interrupt));
}

int compare_poses(const Options& options, const PlanProblem& problem, const PlanningFields& fields, const Interrupt& interrupt) {
  const std::optional<DriveSite> site = drive_site(options, problem.occupancy, interrupt);
  const std::set<double> weights = all_weights(options, problem.query);
  const std::vector<PlanResult> curve =
      trade_off(problem.query, fields, std::vector<double>(weights.begin(), weights.end()), plan_options(interrupt));
  const Comparison comparison{curve.front(),
                              *std::ranges::find(curve, problem.query.weight, [](const PlanResult& at) { return at.query.weight; })};
  const std::vector<PlanResult> limited = within_blind_limits(options, problem.query, fields, curve, interrupt);
  if (interrupt.token().stop_requested()) throw Interrupted();
  Json summary = compare_json(comparison);
  if (!options.weights.empty()) summary["curve"] = plans_json(curve);
  if (!limited.empty()) summary["limited"] = plans_json(limited);
  std::vector<DrivenComparison> driven;
  if (site && solved(comparison)) {
    driven = drive_comparisons({&comparison, 1}, *site, *options.drives, *fields.clearance).front();
    summary["drive"] = drive_json(driven, *options.drives);
  }
  if (options.output) {
    const std::filesystem::path name = output_name(*options.output);
    write_paths(problem, *fields.risk, comparison, name, options.pictures);
    if (!options.weights.empty()) draw_curve(curve, name, options.pictures);
    if (!limited.empty() && solved(comparison)) {
      draw_limits(problem, *fields.risk, comparison.shortest, limited, name, options.pictures);
    }
    write_file(with_ending(name, ".json"), summary.dump(2) + '\n');
  }
  if (options.html && solved(comparison)) {
    std::vector<PlanResult> further = options.weights.empty() ? std::vector<PlanResult>() : curve;
    further.insert(further.end(), limited.begin(), limited.end());
    write_page(options, problem, *fields.risk, comparison, driven, further);
  }
  if (options.json) print({summary});
  if (!solved(comparison)) {
    const PlanResult& failed = comparison.shortest.status != PlanStatus::solved ? comparison.shortest : comparison.risk_aware;
    return say_no(options.problem.file, failed);
  }
  if (!options.json) {
    print_table(comparison);
    print_drive(driven, options.drives.value_or(0));
  }
  if (!options.json && !options.weights.empty()) print_curve(curve);
  if (!options.json && !limited.empty()) print_limits(comparison.shortest, limited);
  return kYes;
}

int compare_random_pairs(const Options& options, const PlanProblem& problem, const PlanningFields& fields, const Interrupt& interrupt) {
  const std::optional<DriveSite> site = drive_site(options, problem.occupancy, interrupt);
  std::vector<Comparison> pairs;
  {
    ProgressBar bar("pairs");
    pairs = compare_pairs(
        problem.query, fields,
        {.count = *options.pairs, .seed = problem.query.planner.seed, .plan = plan_options(interrupt), .progress = bar.callback()});
  }
  Json summary = pairs_json(pairs);
  const std::vector<std::size_t> chosen = most_different(pairs, options.drives ? kDrivenPairs : 0);
  std::vector<std::vector<DrivenComparison>> driven;
  if (site) {
    std::vector<Comparison> different;
    for (const std::size_t number : chosen) different.push_back(pairs[number]);
    driven = drive_comparisons(different, *site, *options.drives, *fields.clearance);
    for (std::size_t i = 0; i < chosen.size(); ++i) summary["each"][chosen[i]]["drive"] = drive_json(driven[i], *options.drives);
  }
  if (options.output) {
    const std::filesystem::path name = output_name(*options.output);
    draw_distribution(pairs, name, options.pictures);
    write_pairs_csv(pairs, with_ending(name, ".csv"));
    write_file(with_ending(name, ".json"), summary.dump(2) + '\n');
  }
  if (options.json) {
    print({summary});
  } else {
    print_distribution(pairs);
    if (options.drives) print_driven_pairs(pairs, chosen, driven, *options.drives);
  }
  return std::ranges::all_of(pairs, solved) ? kYes : kNo;
}

int run(const Options& options) {
  const Interrupt interrupt;
  const PlanProblem problem = load(options.problem);
  const PlanningFields fields(problem);
  return options.pairs ? compare_random_pairs(options, problem, fields, interrupt) : compare_poses(options, problem, fields, interrupt);
}

}  // namespace

void add_compare(CLI::App& app, Work& work, const std::string& command_line) {
  const auto options = std::make_shared<Options>();
  options->command_line = command_line;
  CLI::App* command = app.add_subcommand("compare", "Plan the shortest and the risk-aware path, and put them side by side");
  add_problem_options(*command, options->problem);
  CLI::Option* weights =
      command->add_option("--weights", options->weights, "Further weights, for the curve of length against blind metres: 1,2,5,10")
          ->delimiter(',')
          ->check(CLI::NonNegativeNumber);
  CLI::Option* limits =
      command
          ->add_option("--blind-limits", options->blind_limits,
                       "The shortest path with at most so many blind metres before the robot finds itself, for each: 12,8,4,0")
          ->delimiter(',')
          ->check(CLI::NonNegativeNumber);
  CLI::Option* html =
      command->add_option("--html", options->html, "Writes a page for the browser too: both maps, the paths, α and errors along them")
          ->type_name("FILE");
  command->add_option("--pairs", options->pairs, "Compare between that many random pairs of poses instead, drawn with --seed")
      ->check(CLI::Range(1, 1'000'000))
      ->excludes(weights)
      ->excludes(limits)
      ->excludes(html);
  CLI::Option* drives =
      command
          ->add_option("--drive", options->drives,
                       "Drive both paths that many times and compare how far off a localizer is; with --pairs, the ten that differ most")
          ->check(CLI::Range(1, 100'000));
  for (CLI::Option* option : add_drive_options(*command, options->drive)) option->needs(drives);
  command->add_flag("--json", options->json, "Print JSON");
  command
      ->add_option("-o,--output", options->output,
                   "NAME: writes NAME.json, NAME.png, NAME_shortest.csv and NAME_risk_aware.csv; NAME_curve.png with --weights; "
                   "NAME_limits.png with --blind-limits; "
                   "NAME.json, NAME.png and NAME.csv with --pairs")
      ->type_name("NAME");
  add_picture_option(*command, options->pictures);
  command->footer(
      "Examples:\n"
      "  alignability compare maps/warehouse/problem.yaml --weights 1,2,5,10 -o comparison\n"
      "  alignability compare maps/warehouse/problem.yaml --start 4,28,0 --goal 20,36,0 --blind-limits 12,8,4,0 -o limits\n"
      "  alignability compare maps/warehouse/problem.yaml --drive 20 --html driven.html\n"
      "  alignability compare maps/warehouse/problem.yaml --pairs 100 --iterations 5000 -o pairs");
  command->callback([options, &work] { work = [options] { return run(*options); }; });
}

}  // namespace alignability::cli
