// SPDX-License-Identifier: BSD-3-Clause
#include <chrono>
#include <cstdio>
#include <iostream>
#include <span>

#include "alignability/alignability.hpp"
#include "cli/command.hpp"
#include "cli/json.hpp"
#include "cli/reading_text.hpp"
#include "cli/scoring_options.hpp"
#include "core/input_error.hpp"
#include "core/range.hpp"
#include "lidar/scan_file.hpp"
#include "lidar/sensor_rig.hpp"
#include "lidar/simulate_scan.hpp"
#include "pictures/scan_picture.hpp"

namespace alignability::cli {
namespace {

struct Options {
  std::vector<std::filesystem::path> scans;
  std::optional<std::filesystem::path> sensor;
  std::optional<std::filesystem::path> picture;
  AlignabilityOptions alignability;
  bool json = false;
};

void draw(const Scan& scan, const ScoredScan& scored, const std::filesystem::path& file, const std::filesystem::path& picture_file) {
  const Alignability& result = scored.alignability;
  ScanPictureOptions picture;
  picture.title = file.filename().string();
  picture.lines = {"α = " + fixed_text(result.alpha, 4),
                   std::to_string(result.planes_kept) + " planes of " + std::to_string(result.points) + " points"};
  if (result.planes_kept > 0) picture.weakest_direction = result.weakest_direction;
  draw_scan(scan.points, scored.plane_of_point, picture, picture_file);
}

void print_row(const std::filesystem::path& file, const Alignability& score, std::span<const Reading> readings, double seconds) {
  const Eigen::Vector3d& weakest = score.weakest_direction;
  std::printf("%-28s %8zu %7.4f %7d %6d   (%5.2f, %5.2f, %5.2f) %8.3f", file.filename().c_str(), score.points, score.alpha,
              score.planes_found, score.planes_kept, weakest.x(), weakest.y(), weakest.z(), seconds);
  for (const Reading reading : readings) std::printf("  %8s", reading_text(reading, score.readings).c_str());
  std::printf("\n");
}

void print_header(std::span<const Reading> readings) {
  std::printf("%-28s %8s %7s %7s %6s   %-22s %8s", "scan", "points", "alpha", "planes", "kept", "weakest direction", "seconds");
  for (const Reading reading : readings) std::printf("  %8s", std::string(to_string(reading)).c_str());
  std::printf("\n");
}

Scan read_scan(const std::filesystem::path& file, const std::optional<SensorRig>& sensor) {
  Scan scan = read_scan_file(file);
  if (!sensor) return scan;
  try {
    return told_apart(std::move(scan), *sensor);
  } catch (const std::invalid_argument& error) {
    throw InputError(file, error.what());
  }
}

int run(Options options) {
  if (options.picture && options.scans.size() > 1) throw std::invalid_argument("--picture draws one scan; give one");
  const auto sensor = options.sensor ? std::optional(read_sensor_rig(*options.sensor)) : std::nullopt;
  if (sensor) options.alignability = for_lidar(options.alignability, *sensor);
  Scorer scorer(options.alignability);
  std::vector<Json> objects;
  for (const std::filesystem::path& file : options.scans) {
    const Scan scan = read_scan(file, sensor);
    const auto begin = std::chrono::steady_clock::now();
    const ScoredScan scored = scorer.score(scan);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    if (options.picture) draw(scan, scored, file, *options.picture);
    if (options.json) {
      objects.push_back(score_json(file, scored.alignability, options.alignability, seconds));
    } else {
      if (&file == &options.scans.front()) print_header(options.alignability.readings);
      print_row(file, scored.alignability, options.alignability.readings, seconds);
    }
  }
  if (options.json) print(objects);
  return kYes;
}

}  // namespace

void add_score(CLI::App& app, Work& work) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("score", "Measure the alignability of scans");
  command->add_option("scans", options->scans, "PCD, PLY or .bin files")->type_name("FILE")->required();
  command
      ->add_option("--sensor", options->sensor,
                   "Sensor file: least range, noise, mounts, 2D or 3D (without: 0.5 m, 2 cm, upright, 2D where flat)")
      ->type_name("YAML");
  add_scoring_options(*command, options->alignability);
  command->add_option("--picture", options->picture, "Draw the scan from above, coloured by plane, into a .png, .svg or .pdf")
      ->type_name("FILE");
  command->add_flag("--json", options->json, "Print JSON");
  command->footer(
      "Examples:\n"
      "  alignability score scan.pcd --picture scan.png\n"
      "  alignability score scan.pcd --readings robust,information --sensor maps/sensors/hdl32e.yaml\n"
      "  alignability score scans/*.pcd --json");
  command->callback([options, &work] { work = [options] { return run(*options); }; });
}

}  // namespace alignability::cli
