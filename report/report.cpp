// SPDX-License-Identifier: BSD-3-Clause
#include "report/report.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <nlohmann/json.hpp>
#include <string_view>

#include "pictures/colour_map.hpp"
#include "report/packed_grid.hpp"
#include "report/page.hpp"

namespace alignability {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kMostCells = 2048;  // on a side

double rounded(double value, double step) { return std::round(value / step) * step; }

// Metres to the tenth of a millimetre, numbers to the ten-thousandth.
Json number(double value) { return std::isfinite(value) ? Json(rounded(value, 1e-4)) : Json(nullptr); }
Json number(const std::optional<double>& value) { return value ? number(*value) : Json(nullptr); }

std::string hex(const Colour& colour) {
  char text[8];
  const auto byte = [](double part) { return static_cast<unsigned>(std::lround(255.0 * part)); };
  std::snprintf(text, sizeof text, "#%02x%02x%02x", byte(colour.red), byte(colour.green), byte(colour.blue));
  return text;
}

Json scale_json(const std::string& name, const std::function<Colour(double)>& colour_of) {
  constexpr int kSteps = 64;
  Json colours = Json::array();
  for (int i = 0; i <= kSteps; ++i) colours.push_back(hex(colour_of(static_cast<double>(i) / kSteps)));
  return {{"name", name}, {"colours", colours}};
}

Json grid_json(const GridGeometry& grid) {
  return {{"width", grid.width}, {"height", grid.height}, {"resolution", grid.resolution}, {"origin", {grid.origin.x(), grid.origin.y()}}};
}

Json occupancy_json(const OccupancyMap& occupancy) {
  const GridGeometry blocks = detail::reduced(occupancy.geometry(), kMostCells);
  Json json = grid_json(blocks);
  json["cell"] = occupancy.geometry().resolution;
  json["states"] = detail::packed_occupancy(blocks == occupancy.geometry() ? occupancy : detail::worst_by_block(occupancy, blocks));
  return json;
}

// α at the nodes that the planners interpolate between, by heading where there are any, and which of them were evaluated themselves.
Json alpha_json(const AlignabilityMap& map, const RiskField& risk) {
  const GridGeometry blocks = detail::reduced(map.geometry, kMostCells);
  const auto packed = [&](const BilinearField& field) {
    return detail::packed_shares(blocks == map.geometry ? field.nodes() : detail::least_by_block(field.nodes(), blocks));
  };
  Json fields = Json::array();
  if (risk.has_headings()) {
    for (const BilinearField& field : risk.alpha_headings().at_headings()) fields.push_back(packed(field));
  } else {
    fields.push_back(packed(risk.alpha_layer()));
  }
  const Grid<double> evaluated = [&] {
    Grid<double> alpha(map.geometry, 0.0);
    for (std::size_t i = 0; i < map.geometry.size(); ++i) alpha[i] = map.alpha()[i];
    return detail::least_by_block(alpha, blocks);
  }();
  Json json = grid_json(blocks);
  json["cell"] = map.geometry.resolution;
  json["fields"] = fields;
  json["evaluated"] = detail::packed_bits(blocks.size(), [&](std::size_t i) { return !std::isnan(evaluated[i]); });
  return json;
}

Json errors_json(const ReportedErrors& errors) {
  Json profile = Json::array();
  for (const ErrorPoint& at : errors.profile) profile.push_back({number(at.s), number(at.mean), number(at.p95)});
  return {{"localizer", errors.localizer}, {"runs", errors.runs},         {"mean", number(errors.mean)}, {"p95", number(errors.p95)},
          {"max", number(errors.max)},     {"goal", number(errors.goal)}, {"lost", number(errors.lost)}, {"profile", profile}};
}

Json path_json(const ReportedPath& path, const RiskField& risk) {
  Json samples = Json::array();
  for (const PathSample& at : path.samples) {
    samples.push_back({number(at.s), number(at.pose.x), number(at.pose.y), number(at.pose.yaw), number(at.alpha), number(at.risk)});
  }
  Json errors = Json::array();
  for (const ReportedErrors& by : path.errors) errors.push_back(errors_json(by));
  const PathFigures& figures = path.figures;
  Json sources = Json::array();
  for (std::size_t i = 0; risk.layers().size() > 1 && i < figures.risk_by_source.size(); ++i) {
    sources.push_back({risk.layers()[i].name, number(figures.risk_by_source[i])});
  }
  return {{"name", path.name},
          {"colour", hex(path.colour)},
          {"dashed", path.style == LineStyle::dashed},
          {"length", number(figures.length)},
          {"blind", number(figures.blind_length)},
          {"longest_blind", number(figures.longest_blind)},
          {"risk", number(figures.risk_integral)},
          {"sources", sources},
          {"alpha_mean", number(figures.alpha_mean)},
          {"alpha_min", number(figures.alpha_min)},
          {"cost", number(path.cost)},
          {"bound", number(path.bound)},
          {"seconds", number(path.planning_seconds)},
          {"errors", errors},
          {"samples", samples}};
}

Json report_json(const Report& report, const PlanProblem& problem, const RiskField& risk) {
  const RiskOptions& options = risk.options();
  const PlanQuery& query = problem.query;
  Json paths = Json::array();
  for (const ReportedPath& path : report.paths) paths.push_back(path_json(path, risk));
  Json texts = Json::array();
  for (const ReportedOptions& text : report.options) texts.push_back({{"title", text.title}, {"text", text.text}});
  const auto pose = [](const Pose2& at) { return Json{number(at.x), number(at.y), number(at.yaw)}; };
  return {{"title", report.title},
          {"summary", report.summary},
          {"command", report.command},
          {"risk",
           {{"critical", options.alpha_critical},
            {"safe", options.alpha_safe},
            {"unknown", to_string(options.unknown)},
            {"alpha_weight", options.alpha_weight}}},
          {"start", pose(query.start)},
          {"goal", pose(query.goal)},
          {"occupancy", occupancy_json(problem.occupancy)},
          {"alpha", alpha_json(problem.alignability, risk)},
          {"scales",
           {scale_json("even lightness", [](double alpha) { return detail::error_colour(1.0 - alpha); }),
            scale_json("red to blue, as in the paper", [](double alpha) { return detail::alignability_colour(alpha, detail::Tone::full); }),
            scale_json("grey", [](double alpha) { return detail::mixed(detail::kInk, detail::kWhite, 0.15 + 0.85 * alpha); })}},
          {"paths", paths},
          {"options", texts}};
}

// No character that could end the element it stands in.
std::string script_text(const Json& json) {
  const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string safe;
  safe.reserve(text.size());
  for (const char c : text) c == '<' ? safe.append("\\u003c") : safe.append(1, c);
  return safe;
}

std::string html_text(std::string_view text) {
  // Through JSON and back, which mends what is no UTF-8.
  const std::string mended = Json::parse(Json(text).dump(-1, ' ', false, Json::error_handler_t::replace)).get<std::string>();
  std::string safe;
  for (const char c : mended) {
    c == '<' ? safe.append("&lt;") : c == '&' ? safe.append("&amp;") : safe.append(1, c);
  }
  return safe;
}

}  // namespace

std::string to_html(const Report& report, const PlanProblem& problem, const RiskField& risk) {
  struct Place {
    std::string_view mark;
    std::string text;
  };
  const std::array places{Place{"@title@", html_text(report.title)}, Place{"@style@", std::string(detail::kPageStyle)},
                          Place{"@report@", script_text(report_json(report, problem, risk))},
                          Place{"@script@", std::string(detail::kPageScript)}};
  std::string html;
  std::string_view rest = detail::kPageFrame;
  for (const Place& place : places) {
    const std::size_t at = rest.find(place.mark);
    html.append(rest.substr(0, at)).append(place.text);
    rest.remove_prefix(at + place.mark.size());
  }
  return html.append(rest);
}

}  // namespace alignability
