// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstdio>
#include <iostream>
#include <span>

#include "alignability/build_map.hpp"
#include "alignability/explanation.hpp"
#include "cli/command.hpp"
#include "cli/json.hpp"
#include "cli/output_name.hpp"
#include "cli/picture_option.hpp"
#include "cli/reading_text.hpp"
#include "cli/scene_options.hpp"
#include "cli/scoring_options.hpp"
#include "core/file.hpp"
#include "core/input_error.hpp"
#include "core/range.hpp"
#include "core/yaml_map.hpp"
#include "costmap/heading_layers.hpp"
#include "costmap/map_server.hpp"
#include "lidar/scene.hpp"
#include "lidar/sensor_rig.hpp"
#include "lidar/simulate_scan.hpp"
#include "pictures/scan_picture.hpp"
#include "planner/plan_problem.hpp"

namespace alignability::cli {
namespace {

struct Options {
  std::vector<double> at;
  std::optional<std::filesystem::path> problem;
  std::optional<std::filesystem::path> scene;
  SiteOptions reading;
  std::optional<std::filesystem::path> sensor;
  std::optional<std::filesystem::path> occupancy;
  std::optional<std::filesystem::path> alignability;
  std::optional<double> range_max;
  double floor = 0.0;
  std::uint64_t seed = 1;
  AlignabilityOptions scoring;
  bool json = false;
  std::optional<std::filesystem::path> output;
  PictureKinds pictures;

  Eigen::Vector2d place() const { return {at[0], at[1]}; }
  Pose2 pose() const { return {at[0], at[1], at.size() == 3 ? at[2] : 0.0}; }
  std::string place_text() const { return to_text(at[0]) + ", " + to_text(at[1]); }
};

// Puts what a problem file names where the command line says nothing. Returns the file's thresholds.
RiskOptions complete(Options& options) {
  RiskOptions risk;
  if (options.problem) {
    const ProblemFile file = read_problem_file(*options.problem);
    if (!options.scene) options.scene = file.scene;
    if (!options.sensor) options.sensor = file.sensor;
    if (!options.range_max) options.range_max = file.range_max;
    if (!options.occupancy) options.occupancy = file.map;
    if (!options.alignability) options.alignability = file.alignability.front();
    risk = file.query.risk;
    if (!options.scene) throw InputError(*options.problem, "names no 'scene'; give --scene");
    if (!options.sensor) throw InputError(*options.problem, "names no 'sensor'; give --sensor");
  }
  if (!options.scene) throw std::invalid_argument("--scene is required, or a --problem that names one");
  if (!options.sensor) throw std::invalid_argument("--sensor is required, or a --problem that names one");
  return risk;
}

[[noreturn]] void fail_off(const Options& options, const std::filesystem::path& file, const Eigen::Vector2d& low,
                           const Eigen::Vector2d& high) {
  const auto text = [](double value) { return fixed_text(value, 1); };
  throw InputError(file, "the place " + options.place_text() + " lies off it; it goes from " + text(low.x()) + ", " + text(low.y()) +
                             " to " + text(high.x()) + ", " + text(high.y()));
}

Cell cell_at(const Options& options, const GridGeometry& geometry, const std::filesystem::path& file) {
  const auto cell = geometry.cell_near(options.place());
  if (!cell) fail_off(options, file, geometry.origin, geometry.upper_corner());
  return *cell;
}

std::optional<OccupancyMap> read_occupancy(const Options& options) {
  if (!options.occupancy) return std::nullopt;
  OccupancyMap map = read_occupancy_map(*options.occupancy);
  const Cell cell = cell_at(options, map.geometry(), *options.occupancy);
  if (!map.is_free(cell)) {
    const char* const state = map.occupancy(cell) ? "occupied" : "unknown";
    throw InputError(*options.occupancy, "the place " + options.place_text() + " is " + state + "; a robot stands where it is free");
  }
  return map;
}

void check_place(const Options& options, const Scene& scene, const SensorRig& sensor, const Eigen::Isometry3d& T_map_base) {
  const Eigen::AlignedBox3f bounds = scene.bounds();
  const Eigen::Vector2f place = options.place().cast<float>();
  if (!(place.array() >= bounds.min().head<2>().array()).all() || !(place.array() <= bounds.max().head<2>().array()).all()) {
    fail_off(options, *options.scene, bounds.min().head<2>().cast<double>(), bounds.max().head<2>().cast<double>());
  }
  for (const LidarModel& lidar : sensor.lidars) {
    if (scene.is_free((T_map_base * lidar.T_base_lidar).translation().cast<float>(), kSensorClearance)) continue;
    throw InputError(*options.scene, "at " + options.place_text() + " the sensor would be in a surface or within " +
                                         fixed_text(kSensorClearance, 1) + " m of one");
  }
}

// What the alignability map has for the cell that holds the place.
struct MapCell {
  double alpha = 0.0;              // of the lowest heading; NaN = not evaluated
  std::vector<double> by_heading;  // the k-th of n at yaw 2πk/n; of a map that has them
  double samples = 0.0;
  double iqr = 0.0;
};

void warn_of_differences(const Options& options, const AlignabilityMap& map, const SensorRig& sensor) {
  const auto warn = [&](const std::string& what) {
    std::cerr << "warning: " << options.alignability->string() << " was made " << what << '\n';
  };
  if (map.sensor != sensor.yaml) warn("with another sensor file");
  const auto range_max = YamlMap::from_text(map.options, *options.alignability).find_number("range_max", kPositive);
  if (range_max != options.range_max) warn(range_max ? "with --range-max " + to_text(*range_max) : "without --range-max");
}

std::optional<MapCell> read_map_cell(const Options& options, const SensorRig& sensor) {
  if (!options.alignability) return std::nullopt;
  const AlignabilityMap map = read_alignability_map(*options.alignability);
  warn_of_differences(options, map, sensor);
  const Cell cell = cell_at(options, map.geometry, *options.alignability);
  const auto value = [&](const char* name) {
    const Grid<float>* const layer = map.find_layer(name);
    return layer != nullptr ? static_cast<double>((*layer)[cell]) : std::nan("");
  };
  MapCell found{.alpha = value("alpha"), .by_heading = {}, .samples = value("samples"), .iqr = value("iqr")};
  for (const Grid<float>* layer : heading_layers(map)) found.by_heading.push_back((*layer)[cell]);
  return found;
}

std::string percent(double share) { return fixed_text(100.0 * share, 1) + " %"; }

struct Rest {
  std::size_t planes = 0;
  double share = 0.0;
  double holds = 0.0;
};

// What the planes beyond the largest come to.
Rest rest_of(const Explanation& explanation) {
  Rest rest;
  for (std::size_t i = kNamedPlanes; i < explanation.planes.size(); ++i) {
    ++rest.planes;
    rest.share += explanation.planes[i].share;
    rest.holds += explanation.planes[i].holds;
  }
  return rest;
}

std::string size_text(const ExplainedPlane& plane, int dimensions) {
  const std::string length = fixed_text(plane.extents[0], 2);
  return dimensions == 2 ? length + " m" : length + " x " + fixed_text(plane.extents[1], 2) + " m";
}

void print_table(const Explanation& explanation) {
  const auto row = [](const std::string& plane, const std::string& normal, const std::string& share, const std::string& distance,
                      const std::string& size, const std::string& holds) {
    std::printf("%-10s%-22s%9s%11s%17s%10s\n", plane.c_str(), normal.c_str(), share.c_str(), distance.c_str(), size.c_str(), holds.c_str());
  };
  row("plane", "normal", "share", "distance", "size", "holds");
  for (std::size_t i = 0; i < std::min(explanation.planes.size(), kNamedPlanes); ++i) {
    const ExplainedPlane& plane = explanation.planes[i];
    row(std::string(to_string(plane.kind)), direction_text(plane.normal), percent(plane.share), fixed_text(plane.distance, 2) + " m",
        size_text(plane, explanation.alignability.dimensions), percent(plane.holds));
  }
  if (const Rest rest = rest_of(explanation); rest.planes > 0) {
    row(std::to_string(rest.planes) + " smaller", "", percent(rest.share), "", "", percent(rest.holds));
  }
  std::printf(
      "share: of the normals; holds: of what keeps the scan from sliding along the weakest axis. A floor's normal is\n"
      "within 30 deg of up, a ceiling's of down, a wall's of level; a slope's is between.\n\n");
}

std::string vector_text(const Eigen::Vector3d& vector, int decimals) {
  return fixed_text(vector.x(), decimals) + ", " + fixed_text(vector.y(), decimals) + ", " + fixed_text(vector.z(), decimals);
}

std::string eigenvalues_text(const Alignability& result) {
  if (result.dimensions == 3) return vector_text(result.eigenvalues, 4);
  return fixed_text(result.eigenvalues.x(), 4) + ", " + fixed_text(result.eigenvalues.y(), 4);
}

// "up", "heading 61 deg".
std::string axis_text(const Eigen::Vector3d& axis) {
  const std::string text = direction_text(axis);
  return text == "up" ? text : "heading " + text;
}

std::string heading_text(std::size_t heading, std::size_t headings) {
  return "heading " + fixed_text(360.0 * static_cast<double>(heading) / static_cast<double>(headings), 0) + " deg";
}

std::string alpha_text(double alpha) { return std::isnan(alpha) ? "not evaluated" : "alpha " + fixed_text(alpha, 3); }

std::string headings_text(const std::vector<double>& alphas, double yaw) {
  const std::size_t here = nearest_heading(yaw, alphas.size());
  const auto best = std::ranges::max_element(alphas, [](double a, double b) { return a < b || (std::isnan(a) && !std::isnan(b)); });
  return alpha_text(alphas[here]) + " at " + heading_text(here, alphas.size()) + ", the best " + alpha_text(*best) + " at " +
         heading_text(static_cast<std::size_t>(best - alphas.begin()), alphas.size());
}

std::string map_text(const MapCell& cell) {
  if (std::isnan(cell.alpha)) return "not evaluated in this cell";
  const std::string lowest = cell.by_heading.empty() ? "" : " at the worst heading";
  const std::string alpha = "alpha " + fixed_text(cell.alpha, 3) + " in this cell" + lowest + ", ";
  if (!(cell.samples > 1.0)) return alpha + "from one scan";
  return alpha + "the median of " + fixed_text(cell.samples, 0) + " scans (interquartile range " + fixed_text(cell.iqr, 3) + ")";
}

void print_explanation(const Explanation& explanation, std::span<const Reading> readings, const std::string& why,
                       const std::optional<MapCell>& cell, double yaw) {
  std::printf("%s\n\n", why.c_str());
  if (!explanation.planes.empty()) {
    print_table(explanation);
    const Eigen::Vector3d axis = explanation.weakest_axis();
    std::printf("%-15s%s\n", "eigenvalues", eigenvalues_text(explanation.alignability).c_str());
    std::printf("%-15s(%s) in map, %s\n", "weakest axis", vector_text(axis, 3).c_str(), axis_text(axis).c_str());
  }
  std::printf("%-15salpha %.3f\n", "this scan", explanation.alignability.alpha);
  for (const Reading reading : readings) {
    std::printf("%-15s%s\n", std::string(to_string(reading)).c_str(), reading_text(reading, explanation.alignability.readings).c_str());
  }
  std::printf("%-15s%s deg\n", "heading", fixed_text(degrees(yaw), 0).c_str());
  if (cell) std::printf("%-15s%s\n", "map", map_text(*cell).c_str());
  if (cell && !cell->by_heading.empty()) std::printf("%-15s%s\n", "", headings_text(cell->by_heading, yaw).c_str());
}

void draw(const Scan& scan, const Explanation& explanation, const Options& options, Verdict verdict, const Eigen::Isometry3d& T_map_scan,
          const std::optional<OccupancyMap>& occupancy) {
  const Alignability& result = explanation.alignability;
  ScanPictureOptions picture;
  picture.title = options.place_text() + ": " + std::string(to_string(verdict)) + ", α = " + fixed_text(result.alpha, 3);
  if (!explanation.planes.empty()) {
    picture.lines = {"held least " + weakest_text(explanation), "of the hold, " + percent(explanation.noise) + " is noise"};
    picture.weakest_direction = result.weakest_direction;
  }
  picture.T_map_lidar = T_map_scan;
  if (occupancy) picture.occupancy = &*occupancy;
  for (const ExplainedPlane& plane : explanation.planes) {
    const bool level = plane.kind == PlaneKind::floor || plane.kind == PlaneKind::ceiling;
    picture.plane_labels.push_back(std::string(to_string(plane.kind)) + (level ? "" : " facing " + direction_text(plane.normal)) + ": " +
                                   percent(plane.share) + ", holds " + percent(plane.holds));
  }
  const Rest rest = rest_of(explanation);
  picture.smaller_planes = std::to_string(rest.planes) + " smaller: " + percent(rest.share) + ", holds " + percent(rest.holds);
  for (const auto& file : picture_files(output_name(*options.output), options.pictures)) {
    draw_scan(scan.points, explanation.plane_of_point, picture, file);
  }
}

int run(Options options) {
  const RiskOptions risk = complete(options);
  const SensorRig sensor = read_sensor_rig(*options.sensor);
  const std::optional<OccupancyMap> occupancy = read_occupancy(options);
  const std::optional<MapCell> cell = read_map_cell(options, sensor);
  const Scene scene = read_scene(*options.scene, options.reading);
  Eigen::Isometry3d T_map_base = Eigen::Isometry3d::Identity();
  T_map_base.linear() = Eigen::AngleAxisd(options.pose().yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  T_map_base.translation() << options.place(), options.floor;
  const Eigen::Isometry3d T_map_scan = T_map_base * sensor.T_base_scan();
  check_place(options, scene, sensor, T_map_base);

  const AlignabilityOptions scoring = for_lidar(options.scoring, sensor);
  const Scan scan = simulate_rig_scan(scene, sensor, T_map_base, {.range_max = options.range_max}, NoiseKey{.seed = options.seed});
  const Explanation explanation = explain(scan, T_map_scan.linear(), sensor.range_stddev(), scoring);

  const Verdict judged = verdict(explanation.alignability.alpha, risk);
  const std::string why = sentence(explanation, risk);
  Json json = explanation_json(options.pose(), explanation, judged, why);
  add_readings(json, explanation.alignability.readings, scoring.readings);
  json["map"] = cell ? Json{{"alpha", cell->alpha}, {"samples", cell->samples}, {"iqr", cell->iqr}} : Json(nullptr);
  if (cell && !cell->by_heading.empty()) json["map"]["alpha_by_heading"] = cell->by_heading;
  if (options.output) {
    draw(scan, explanation, options, judged, T_map_scan, occupancy);
    write_file(with_ending(output_name(*options.output), ".json"), json.dump(2) + '\n');
  }
  if (options.json) {
    print({json});
  } else {
    print_explanation(explanation, scoring.readings, why, cell, options.pose().yaw);
  }
  return kYes;
}

}  // namespace

void add_explain(CLI::App& app, Work& work) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("explain", "Tell why a place scores what it does");
  command->add_option("place", options->at, "Where base_link stands in map: x,y or x,y,yaw [m, rad]; without, yaw is 0")
      ->required()
      ->expected(2, 3)
      ->delimiter(',');
  command->add_option("--problem", options->problem, "Problem file that names scene, sensor, range_max and maps")->type_name("YAML");
  command->add_option("--scene", options->scene, kSiteHelp)->type_name("FILE");
  command->add_option("--sensor", options->sensor, "Sensor file")->type_name("YAML");
  command->add_option("--range-max", options->range_max, "Drop returns beyond [m]")->check(CLI::PositiveNumber);
  command->add_option("--map", options->occupancy, "Occupancy map: refuses a place that is not free, and is drawn")->type_name("YAML");
  command->add_option("--alignability", options->alignability, "Alignability map, whose value is told beside")->type_name("YAML");
  command->add_option("--floor", options->floor, "Height of base_link in map [m]")->capture_default_str();
  command->add_option("--seed", options->seed, "Seed of the range noise")->capture_default_str();
  add_scoring_options(*command, options->scoring);
  command->add_flag("--json", options->json, "Print JSON");
  command->add_option("-o,--output", options->output, "NAME: writes NAME.json and NAME.png, the scan from above")->type_name("NAME");
  add_site_options(*command, options->reading);
  add_picture_option(*command, options->pictures);
  command->footer(
      "Examples:\n"
      "  alignability explain 30,22.5 --problem maps/warehouse/problem.yaml -o corridor\n"
      "  alignability explain 11.5,35 --scene maps/warehouse/warehouse.sdf --sensor maps/sensors/hdl32e.yaml --range-max 6.5 --json");
  command->callback([options, &work] { work = [options] { return run(*options); }; });
}

}  // namespace alignability::cli
