// SPDX-License-Identifier: BSD-3-Clause
#include "cli/evaluate_output.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "cli/output_name.hpp"
#include "cli/path_output.hpp"
#include "core/file.hpp"
#include "core/range.hpp"

namespace alignability::cli {
namespace {

constexpr Colour kWorstColour = colour_from_hex(0x6a2c91);

// A way as a plan that found it.
PlanResult as_plan(const std::vector<Pose2>& path, const WayEvaluation& way, const PlanQuery& query) {
  PlanResult result;
  result.status = PlanStatus::solved;
  result.query = query;
  if (!path.empty()) {
    result.query.start = path.front();
    result.query.goal = path.back();
  }
  result.path = path;
  result.cost = way.cost;
  result.figures = way.figures;
  return result;
}

Json way_json(const std::vector<Pose2>& path, const WayEvaluation& way, const PlanQuery& query) {
  Json json = plan_json(as_plan(path, way, query));
  json["status"] = to_string(way.status);
  json["planner"] = nullptr;
  json["seed"] = nullptr;
  json["options"].erase("planner");
  json["obstruction"] = nullptr;
  if (way.obstruction) json["obstruction"] = {way.obstruction->x, way.obstruction->y, way.obstruction->yaw};
  return json;
}

Json edge_json(const EdgeEvaluation& evaluated, const RouteGraph& graph, const PlanQuery& query) {
  const RouteEdge& edge = evaluated.edge;
  Json json{{"id", edge.id}, {"from", graph.nodes[edge.from].id}, {"to", graph.nodes[edge.to].id}};
  json.update(way_json(edge.path, evaluated.way, query));
  for (const char* shared : {"planner", "seed", "weight", "options", "lower_bound", "seconds", "first_solution_seconds"}) {
    json.erase(shared);
  }
  return json;
}

void print_row(const std::string& name, int width, const WayEvaluation& way) {
  const PathFigures& figures = way.figures;
  std::printf("%-*s %9.2f m %9.2f m %9.2f m %9.2f m %7.3f %7.3f", width, name.c_str(), figures.length, figures.blind_length,
              figures.longest_blind, figures.risk_integral, figures.alpha_mean, figures.alpha_min);
}

void print_edges(const EvaluatedRoute& evaluated) {
  const std::vector<RouteNode>& nodes = evaluated.route.graph.nodes;
  const auto name = [&](const RouteEdge& edge) { return edge.id + ": " + nodes[edge.from].id + " - " + nodes[edge.to].id; };
  const std::string total = "all " + std::to_string(evaluated.evaluation.edges.size()) + " edges";
  std::size_t width = total.size();
  for (const EdgeEvaluation& edge : evaluated.evaluation.edges) width = std::max(width, name(edge.edge).size());
  const int columns = static_cast<int>(width);
  std::printf("%-*s %9s   %9s   %9s   %9s   %7s %7s\n", columns, "edge", "length", "blind", "longest", "risk", "alpha", "least");
  for (const EdgeEvaluation& edge : evaluated.evaluation.edges) {
    print_row(name(edge.edge), columns, edge.way);
    std::printf("%s%s\n", edge.way.obstruction ? "  " : "", obstruction_text(edge.way).c_str());
  }
  print_row(total, columns, evaluated.evaluation.total);
  std::printf("\n");
}

// As RFC 4180 has it.
std::string csv_text(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text) quoted += letter == '"' ? "\"\"" : std::string(1, letter);
  return quoted + '"';
}

void write_edges_csv(const EvaluatedRoute& evaluated, const std::filesystem::path& csv) {
  std::string text = "id,from,to,status,x,y,cost,length,risk_integral,blind_length,longest_blind,alpha_mean,alpha_min";
  const std::vector<std::string> sources = source_labels(evaluated.problem.query.risk, "risk_");
  for (const std::string& source : sources) text.append(",").append(source);
  text += '\n';
  for (const auto& [edge, way] : evaluated.evaluation.edges) {
    text += csv_text(edge.id);
    for (const std::size_t node : {edge.from, edge.to}) text += ',' + csv_text(evaluated.route.graph.nodes[node].id);
    text += ',' + std::string(to_string(way.status)) + ',';
    if (way.obstruction) text += to_text(way.obstruction->x) + ',' + to_text(way.obstruction->y);
    if (!way.obstruction) text += ',';
    const PathFigures& figures = way.figures;
    for (const double value : {way.cost, figures.length, figures.risk_integral, figures.blind_length, figures.longest_blind,
                               figures.alpha_mean, figures.alpha_min}) {
      text += ',' + (std::isnan(value) ? "" : to_text(value));
    }
    for (std::size_t i = 0; i < sources.size(); ++i) text.append(",").append(to_text(figures.risk_by_source[i]));
    text += '\n';
  }
  write_file(csv, text);
}

// All edges, the worst of them last and so on top, with its profile.
std::vector<DrawnPath> drawn_edges(const EvaluatedRoute& evaluated, const RiskField& risk) {
  const PlanQuery& query = evaluated.problem.query;
  const std::vector<EdgeEvaluation>& edges = evaluated.evaluation.edges;
  const auto drawn_edge = [&](const EdgeEvaluation& edge, Colour colour) {
    return drawn(as_plan(edge.edge.path, edge.way, query), risk, "edge " + edge.edge.id, colour, LineStyle::solid);
  };
  std::vector<DrawnPath> paths;
  for (std::size_t i = edges.size(); i-- > 1;) {
    paths.push_back(drawn_edge(edges[i], kShortestColour));
    paths.back().label.clear();
  }
  paths.push_back(drawn_edge(edges.front(), kWorstColour));
  const PlanResult all = as_plan({}, evaluated.evaluation.total, query);
  paths.push_back(drawn(all, risk, "all " + std::to_string(edges.size()) + " edges", kShortestColour, LineStyle::solid));
  return paths;
}

}  // namespace

Json evaluation_json(const EvaluatedRoute& evaluated) {
  const PlanQuery& query = evaluated.problem.query;
  Json json = way_json(evaluated.route.path, evaluated.evaluation.total, query);
  json["seconds"] = evaluated.evaluation.seconds;
  if (!evaluated.route.path.empty()) return json;
  json["options"].erase("start");
  json["options"].erase("goal");
  for (const EdgeEvaluation& edge : evaluated.evaluation.edges) json["edges"].push_back(edge_json(edge, evaluated.route.graph, query));
  return json;
}

void print_evaluation(const EvaluatedRoute& evaluated) {
  if (evaluated.route.path.empty()) {
    print_edges(evaluated);
  } else {
    std::printf("%-20s %9.2f m\n", "cost", evaluated.evaluation.total.cost);
    print_figures(evaluated.evaluation.total.figures, evaluated.problem.query.risk);
  }
}

std::string obstruction_text(const WayEvaluation& way) {
  if (!way.obstruction) return "";
  const std::string what = way.status == RouteStatus::outside_map    ? "the robot leaves the map"
                           : way.status == RouteStatus::in_collision ? "the robot collides"
                                                                     : "the way is blocked where nobody evaluated it,";
  return what + " at x " + fixed_text(way.obstruction->x, 2) + ", y " + fixed_text(way.obstruction->y, 2);
}

void write_evaluation(const EvaluatedRoute& evaluated, const RiskField& risk, const std::filesystem::path& name,
                      const PictureKinds& kinds) {
  const PlanQuery& query = evaluated.problem.query;
  const std::string title = name.filename().string();
  const std::filesystem::path csv = with_ending(name, ".csv");
  const bool is_path = !evaluated.route.path.empty();
  const PlanResult path = as_plan(evaluated.route.path, evaluated.evaluation.total, query);
  PathPictureOptions options = picture_options(path.query, risk, evaluated.problem.occupancy.geometry(), title);
  if (!is_path) options.start = options.goal = std::nullopt;
  const std::vector<DrawnPath> paths =
      is_path ? std::vector<DrawnPath>{drawn(path, risk, title, kRiskAwareColour, LineStyle::solid)} : drawn_edges(evaluated, risk);
  is_path ? write_path_csv(path, risk, csv) : write_edges_csv(evaluated, csv);
  for (const auto& file : picture_files(name, kinds)) {
    draw_paths(evaluated.problem.alignability, evaluated.problem.occupancy, paths, options, file);
  }
  write_file(with_ending(name, ".json"), evaluation_json(evaluated).dump(2) + '\n');
}

}  // namespace alignability::cli
