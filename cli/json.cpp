// SPDX-License-Identifier: BSD-3-Clause
#include "cli/json.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>

#include "core/distribution.hpp"
#include "costmap/heading_layers.hpp"

namespace alignability::cli {
namespace {

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json number(const std::optional<double>& value) { return value ? number(*value) : Json(nullptr); }

Json vector(const Eigen::Vector3d& value) { return {number(value.x()), number(value.y()), number(value.z())}; }

Json pose(const Pose2& value) { return {number(value.x), number(value.y), number(value.yaw)}; }

Json ratio(double value, double reference) { return reference > 0.0 ? number(value / reference) : Json(nullptr); }

Json distribution_json(const std::vector<double>& values) {
  const Distribution d = distribution_of(values);
  return {{"mean", number(d.mean)}, {"min", number(d.min)}, {"median", number(d.median)}, {"p95", number(d.p95)}, {"max", number(d.max)}};
}

Json motion_json(const Motion& motion) {
  Json json{{"space", to_string(motion.space)}, {"turn_cost", motion.turn_cost}};
  if (is_curved(motion.space)) json["turning_radius"] = motion.turning_radius;
  if (motion.space == MotionSpace::reeds_shepp) json["reverse_penalty"] = motion.reverse_penalty;
  return json;
}

Json source_json(const RiskSource& source) {
  Json json{{"weight", source.weight}};
  if (source.file) {
    json["raster"] = source.file->file.string();
    if (!source.file->layer.empty()) json["layer"] = source.file->layer;
    if (source.file->place) {
      json["resolution"] = source.file->place->resolution;
      json["origin"] = {source.file->place->origin.x(), source.file->place->origin.y()};
    }
  }
  json["risky"] = source.risky;
  json["safe"] = source.safe;
  if (source.file) json["unknown"] = to_string(source.unknown);
  return json;
}

Json options_json(const PlanQuery& query) {
  Json planner{{"name", query.planner.name}};
  if (query.planner.iterations) {
    planner["iterations"] = *query.planner.iterations;
  } else {
    planner["time"] = query.planner.time;
  }
  Json robot{{"radius", query.robot.radius}};
  if (!query.robot.footprint.empty()) {
    Json corners = Json::array();
    for (const Eigen::Vector2d& at : query.robot.footprint) corners.push_back({at.x(), at.y()});
    robot = {{"footprint", corners}};
  }
  Json risk{
      {"alpha_critical", query.risk.alpha_critical}, {"alpha_safe", query.risk.alpha_safe}, {"unknown", to_string(query.risk.unknown)}};
  if (query.risk.alpha_weight != 1.0 || !query.risk.sources.empty())
    risk["sources"] = {{kAlignability, {{"weight", query.risk.alpha_weight}}}};
  for (const RiskSource& source : query.risk.sources) risk["sources"][source.name] = source_json(source);
  if (query.max_error) risk["max_error"] = *query.max_error;
  if (query.risk.min_alpha) risk["min_alignability"] = *query.risk.min_alpha;
  if (query.max_blind_distance) {
    risk["max_blind_distance"] = *query.max_blind_distance;
    risk["recovery_distance"] = query.recovery_distance;
  }
  return {{"robot", robot},
          {"motion", motion_json(query.motion)},
          {"start", pose(query.start)},
          {"goal", pose(query.goal)},
          {"goal_tolerance", {{"position", query.goal_tolerance.position}, {"heading_deg", degrees(query.goal_tolerance.heading)}}},
          {"risk", risk},
          {"planner", planner}};
}

Json risk_by_source_json(const PlanResult& result) {
  Json json;
  const std::vector<std::string> names = names_of_risks(result.query.risk);
  for (std::size_t i = 0; i < names.size(); ++i) json[names[i]] = result.figures.risk_by_source[i];
  return json;
}

Json reading_json(Reading reading, const Readings& readings) {
  if (reading != Reading::information) return number(value_of(reading, readings));
  const PlanarInformation& information = readings.information;
  Json rows = Json::array();
  for (int row = 0; row < 3; ++row) rows.push_back(vector(information.matrix.row(row)));
  return {{"least", number(information.least)},
          {"weakest_direction", {number(information.weakest_direction.x()), number(information.weakest_direction.y())}},
          {"yaw", number(information.yaw)},
          {"matrix", rows}};
}

}  // namespace

Json score_json(const std::filesystem::path& file, const Alignability& score, const AlignabilityOptions& options, double seconds) {
  const bool has_planes = score.planes_kept > 0;
  Json json{{"file", file.string()},
            {"points", score.points},
            {"alpha", score.alpha},
            {"eigenvalues", vector(score.eigenvalues)},
            {"weakest_direction", has_planes ? vector(score.weakest_direction) : Json(nullptr)},
            {"planes_found", score.planes_found},
            {"planes_kept", score.planes_kept},
            {"engine", to_string(options.segmentation.engine)},
            {"seconds", seconds}};
  add_readings(json, score.readings, options.readings);
  return json;
}

void add_readings(Json& json, const Readings& readings, std::span<const Reading> wanted) {
  for (const Reading reading : wanted) json[std::string(to_string(reading))] = reading_json(reading, readings);
}

Json explanation_json(const Pose2& at, const Explanation& explanation, Verdict verdict, const std::string& why) {
  Json planes = Json::array();
  for (const ExplainedPlane& plane : explanation.planes) {
    planes.push_back({{"kind", to_string(plane.kind)},
                      {"normal", vector(plane.normal)},
                      {"segments", plane.segments},
                      {"points", plane.points},
                      {"share", plane.share},
                      {"distance", plane.distance},
                      {"extents", vector(plane.extents)},
                      {"holds", plane.holds}});
  }
  return {{"at", {at.x, at.y}},
          {"yaw", at.yaw},
          {"alpha", explanation.alignability.alpha},
          {"verdict", to_string(verdict)},
          {"why", why},
          {"eigenvalues", vector(explanation.alignability.eigenvalues)},
          {"weakest_direction", planes.empty() ? Json(nullptr) : vector(explanation.weakest_axis())},
          {"noise", explanation.noise},
          {"planes", planes}};
}

Json map_json(const AlignabilityMap& map, double seconds, const std::vector<std::filesystem::path>& files) {
  std::vector<double> alphas;
  double scans = 0.0;
  const Grid<float>* samples = map.find_layer("samples");
  for (std::size_t i = 0; i < map.geometry.size(); ++i) {
    if (!std::isnan(map.alpha()[i])) alphas.push_back(map.alpha()[i]);
    if (samples != nullptr && !std::isnan((*samples)[i])) scans += (*samples)[i];
  }
  std::ranges::sort(alphas);
  const auto at = [&](double share) {
    return alphas.empty() ? Json(nullptr) : Json(alphas[static_cast<std::size_t>(share * static_cast<double>(alphas.size() - 1))]);
  };
  Json names = Json::array();
  for (const std::filesystem::path& file : files) names.push_back(file.string());
  return {{"cells", map.geometry.size()},
          {"cells_evaluated", alphas.size()},
          {"scans", static_cast<std::uint64_t>(scans) * std::max<std::uint64_t>(heading_layers(map).size(), 1)},
          {"alpha", {{"min", at(0.0)}, {"median", at(0.5)}, {"max", at(1.0)}}},
          {"seconds", seconds},
          {"files", names}};
}

Json path_json(std::span<const Pose2> path) {
  Json poses = Json::array();
  for (const Pose2& at : path) poses.push_back(pose(at));
  return poses;
}

Json plan_json(const PlanResult& result) {
  const bool solved = result.status == PlanStatus::solved;
  const auto figure = [&](double value) { return solved ? number(value) : Json(nullptr); };
  Json json{{"status", to_string(result.status)},
            {"planner", result.query.planner.name},
            {"seed", result.query.planner.seed},
            {"weight", result.query.weight},
            {"options", options_json(result.query)},
            {"cost", figure(result.cost)},
            {"lower_bound", number(result.lower_bound)},
            {"length", figure(result.figures.length)},
            {"risk_integral", figure(result.figures.risk_integral)},
            {"blind_length", figure(result.figures.blind_length)},
            {"longest_blind", figure(result.figures.longest_blind)},
            {"alpha_mean", figure(result.figures.alpha_mean)},
            {"alpha_min", figure(result.figures.alpha_min)},
            {"seconds", result.seconds},
            {"first_solution_seconds", number(result.first_solution_seconds)},
            {"path", path_json(result.path)}};
  if (solved && !result.query.risk.sources.empty()) json["risk_by_source"] = risk_by_source_json(result);
  if (result.predicted_error) json["predicted_error"] = *result.predicted_error;
  if (result.longest_unrecovered) json["longest_unrecovered"] = *result.longest_unrecovered;
  if (result.smallest_max_error) json["smallest_max_error"] = *result.smallest_max_error;
  if (result.smallest_max_blind_distance) json["smallest_max_blind_distance"] = *result.smallest_max_blind_distance;
  if (result.greatest_min_alpha) json["greatest_min_alignability"] = *result.greatest_min_alpha;
  return json;
}

Json plans_json(std::span<const PlanResult> results) {
  Json list = Json::array();
  for (const PlanResult& result : results) list.push_back(plan_json(result));
  return list;
}

Json compare_json(const Comparison& comparison) {
  const PathFigures& shortest = comparison.shortest.figures;
  const PathFigures& risk_aware = comparison.risk_aware.figures;
  return {{"shortest", plan_json(comparison.shortest)},
          {"risk_aware", plan_json(comparison.risk_aware)},
          {"ratio",
           {{"length", ratio(risk_aware.length, shortest.length)},
            {"blind_length", ratio(risk_aware.blind_length, shortest.blind_length)},
            {"risk_integral", ratio(risk_aware.risk_integral, shortest.risk_integral)}}}};
}

Json pairs_json(std::span<const Comparison> pairs) {
  std::vector<double> ratios, shortest_blind, risk_aware_blind, shortest_risk, risk_aware_risk;
  Json list = Json::array();
  for (const Comparison& pair : pairs) {
    Json entry{{"start", pose(pair.shortest.query.start)},
               {"goal", pose(pair.shortest.query.goal)},
               {"shortest", plan_json(pair.shortest)},
               {"risk_aware", plan_json(pair.risk_aware)}};
    for (const char* path : {"shortest", "risk_aware"}) {
      entry[path].erase("path");
      entry[path].erase("options");
    }
    list.push_back(entry);
    if (!solved(pair)) continue;
    ratios.push_back(length_ratio(pair));
    shortest_blind.push_back(pair.shortest.figures.blind_length);
    risk_aware_blind.push_back(pair.risk_aware.figures.blind_length);
    shortest_risk.push_back(pair.shortest.figures.risk_integral);
    risk_aware_risk.push_back(pair.risk_aware.figures.risk_integral);
  }
  return {{"pairs", pairs.size()},
          {"solved", ratios.size()},
          {"length_ratio", distribution_json(ratios)},
          {"blind_length", {{"shortest", distribution_json(shortest_blind)}, {"risk_aware", distribution_json(risk_aware_blind)}}},
          {"risk_integral", {{"shortest", distribution_json(shortest_risk)}, {"risk_aware", distribution_json(risk_aware_risk)}}},
          {"each", list}};
}

void print(const std::vector<Json>& objects) {
  if (objects.size() == 1) {
    std::cout << objects.front().dump(2) << '\n';
  } else {
    std::cout << Json(objects).dump(2) << '\n';
  }
}

}  // namespace alignability::cli
