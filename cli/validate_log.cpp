// SPDX-License-Identifier: BSD-3-Clause
#include "cli/validate_log.hpp"

#include <algorithm>
#include <array>
#include <iostream>
#include <sstream>

#include "alignability/log_map.hpp"
#include "cli/interrupt.hpp"
#include "cli/json.hpp"
#include "cli/log_options.hpp"
#include "cli/output_name.hpp"
#include "cli/picture_option.hpp"
#include "cli/progress_bar.hpp"
#include "cli/scene_options.hpp"
#include "cli/scoring_options.hpp"
#include "core/distribution.hpp"
#include "core/file.hpp"
#include "core/range.hpp"
#include "core/rank_correlation.hpp"
#include "costmap/risk_field.hpp"
#include "pictures/scatter_picture.hpp"

namespace alignability::cli {
namespace {

struct Options {
  LogOptions log;
  std::filesystem::path scene;
  SiteOptions reading;
  std::filesystem::path sensor;
  LogMapOptions scoring;
  std::uint64_t seed = 1;
  bool json = false;
  std::optional<std::filesystem::path> output;
  PictureKinds pictures;
};

struct Both {
  std::vector<ScoredPlace> recorded;
  std::vector<ScoredPlace> simulated;

  std::size_t size() const { return recorded.size(); }
  double difference(std::size_t i) const { return simulated[i].score.alpha - recorded[i].score.alpha; }
};

Both score_both(const ScanLog& log, const Scene& scene, const LidarModel& lidar, const Options& options) {
  ProgressBar recorded_bar("recorded");
  LogMapOptions scoring = options.scoring;
  scoring.progress = recorded_bar.callback();
  Both both{.recorded = score_log(log.scans, scoring), .simulated = {}};
  ProgressBar simulated_bar("simulated");
  scoring.progress = simulated_bar.callback();
  both.simulated = score_simulated_log(log.scans, scene, lidar, options.seed, scoring);
  return both;
}

std::vector<double> alphas(const std::vector<ScoredPlace>& places) {
  std::vector<double> values;
  for (const ScoredPlace& place : places) values.push_back(place.score.alpha);
  return values;
}

Json summary_of(const Both& both) {
  std::vector<double> off;
  for (std::size_t i = 0; i < both.size(); ++i) off.push_back(std::abs(both.difference(i)));
  const Distribution difference = distribution_of(off);
  return {{"scans", both.size()},
          {"rank_correlation", rank_correlation(alphas(both.recorded), alphas(both.simulated))},
          {"difference", {{"median", difference.median}, {"p95", difference.p95}, {"max", difference.max}}}};
}

std::string csv(const ScanLog& log, const Both& both) {
  std::ostringstream out;
  out << "scan,x,y,z,recorded_alpha,simulated_alpha,recorded_points,simulated_points,recorded_planes,simulated_planes\n";
  for (std::size_t i = 0; i < both.size(); ++i) {
    const Eigen::Vector3d at = log.scans[i].T_map_lidar.translation();
    const Alignability &recorded = both.recorded[i].score, &simulated = both.simulated[i].score;
    out << log.scans[i].file.filename().string();
    for (const double value : {at.x(), at.y(), at.z()}) out << ',' << fixed_text(value, 4);
    for (const double value : {recorded.alpha, simulated.alpha}) out << ',' << fixed_text(value, 6);
    out << ',' << recorded.points << ',' << simulated.points << ',' << recorded.planes_kept << ',' << simulated.planes_kept << '\n';
  }
  return out.str();
}

void draw(const Both& both, const std::filesystem::path& name, const PictureKinds& kinds) {
  ScatterSeries equal{.label = "equal", .points = {}, .colour = {0.6, 0.6, 0.6}};
  ScatterSeries scans{.label = "a scan", .points = {}};
  for (std::size_t i = 0; i < both.size(); ++i) scans.points.emplace_back(both.recorded[i].score.alpha, both.simulated[i].score.alpha);
  const RiskOptions risk;
  double most = risk.alpha_safe;
  for (const Eigen::Vector2d& point : scans.points) most = std::max(most, point.maxCoeff());
  for (int i = 0; i <= 80; ++i) equal.points.emplace_back(i / 80.0 * most, i / 80.0 * most);
  const std::vector<Threshold> thresholds{{risk.alpha_critical, "blind"}, {risk.alpha_safe, "safe"}};
  const ScatterPanel panel{{.name = "alignability, recorded", .thresholds = thresholds},
                           {.name = "alignability, simulated", .thresholds = thresholds},
                           {equal, scans}};
  for (const auto& file : picture_files(name, kinds)) draw_scatter(std::array{panel}, name.filename().string(), file);
}

int run(Options options) {
  const Interrupt interrupt;
  if (options.reading.level) throw std::invalid_argument("--level: would turn the site from under the poses of the log");
  const LidarModel lidar = read_lidar_model(options.sensor);
  const ScanLog log = read_log(options.log, lidar);
  const Scene scene = read_scene(options.scene, options.reading);
  options.scoring.alignability = for_lidar(options.scoring.alignability, lidar);
  options.scoring.stop = interrupt.token();
  const Both both = score_both(log, scene, lidar, options);
  Json summary = summary_of(both);
  if (options.output) {
    const std::filesystem::path name = output_name(*options.output);
    write_file(with_ending(name, ".csv"), csv(log, both));
    draw(both, name, options.pictures);
    summary["files"] = {with_ending(name, ".csv").string()};
    for (const auto& file : picture_files(name, options.pictures)) summary["files"].push_back(file.string());
  }
  if (options.json) {
    print({summary});
    return kYes;
  }
  const Json& difference = summary["difference"];
  std::cout << both.size() << " scans: simulated alpha is off by " << fixed_text(difference["median"], 3) << " in the median, "
            << fixed_text(difference["p95"], 3) << " at 95 % and " << fixed_text(difference["max"], 3) << " at most; rank correlation "
            << fixed_text(summary["rank_correlation"], 3) << '\n';
  return kYes;
}

}  // namespace

void add_validate_log(CLI::App& validate, Work& work) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = validate.add_subcommand(
      "log", "Hold the alignability of recorded scans against that of scans simulated in a site from the same poses");
  command->add_option("log", options->log.folder, "Folder of recorded scans: .pcd, .ply, .bin; or a CARMEN log: .log, .clf")
      ->type_name("PATH")
      ->required();
  add_log_options(*command, options->log);
  command->add_option("--scene", options->scene, kSiteHelp)->type_name("FILE")->required();
  command->add_option("--sensor", options->sensor, "Sensor file")->type_name("YAML")->required();
  command->add_option("--range-max", options->scoring.range_max, "Crop both to this range [m]")->check(CLI::PositiveNumber);
  command->add_option("--seed", options->seed, "Seed of range noise")->capture_default_str();
  command->add_option("--threads", options->scoring.threads, "0: one a processor")->check(CLI::NonNegativeNumber)->capture_default_str();
  add_site_options(*command, options->reading);
  add_scoring_options(*command, options->scoring.alignability);
  command->add_flag("--json", options->json, "Print JSON");
  command->add_option("-o,--output", options->output, "NAME: writes NAME.csv and NAME.png")->type_name("NAME");
  add_picture_option(*command, options->pictures);
  command->footer(
      "Example:\n"
      "  alignability join scans --trajectory poses.txt --thin 0.05 -o cloud.pcd\n"
      "  alignability validate log scans --trajectory poses.txt --scene cloud.pcd --sensor maps/sensors/os1-64.yaml -o followed");
  command->callback([options, &work] { work = [options] { return run(*options); }; });
}

}  // namespace alignability::cli
