// SPDX-License-Identifier: BSD-3-Clause
#include "cli/path_output.hpp"

#include <cmath>
#include <cstdio>
#include <iostream>

#include "cli/exit_code.hpp"
#include "core/file.hpp"
#include "core/range.hpp"
#include "planner/path_figures.hpp"

namespace alignability::cli {
namespace {

const char* explanation(PlanStatus status) {
  switch (status) {
    case PlanStatus::solved:
      return "solved";
    case PlanStatus::no_path:
      return "there is no path: the goal is walled off";
    case PlanStatus::timeout:
      return "no path was found in the time given; try a longer --time or another --planner";
    case PlanStatus::infeasible:
      return "no path was found that keeps the limit";
    case PlanStatus::start_in_collision:
      return "the robot collides at the start";
    case PlanStatus::goal_in_collision:
      return "the robot collides at the goal";
    case PlanStatus::start_outside_map:
      return "the start lies off the map";
    case PlanStatus::goal_outside_map:
      return "the goal lies off the map";
    case PlanStatus::interrupted:
      return "interrupted";
  }
  return "";
}

// At the centres of cells as small as the map's, or as a picture can show; where it depends on heading, at the best.
Grid<float> drawn_risk(const RiskField& risk, const GridGeometry& map) {
  constexpr double kMostCells = 1000.0;  // along a side
  GridGeometry cells = map;
  cells.resolution = std::max(map.resolution, map.extent().maxCoeff() / kMostCells);
  cells.width = static_cast<int>(std::ceil(map.extent().x() / cells.resolution - 1e-9));
  cells.height = static_cast<int>(std::ceil(map.extent().y() / cells.resolution - 1e-9));
  Grid<float> drawn(cells, 0.0f);
  for (std::size_t i = 0; i < drawn.values().size(); ++i) {
    const Eigen::Vector2d at = cells.center(cells.cell_of(i));
    drawn[i] = static_cast<float>(risk.least_risk(at));
  }
  return drawn;
}

// Rounded up, so that it will do.
std::string hundredths_up(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", std::ceil(100.0 * value) / 100.0);
  return text;
}

}  // namespace

void write_path_csv(const PlanResult& result, const RiskField& risk, const std::filesystem::path& csv) {
  const std::vector<std::string> sources = source_labels(risk.options(), "risk_");
  std::string text = "x,y,yaw,s,alpha,risk";
  for (const std::string& source : sources) text.append(",").append(source);
  text += '\n';
  for (const PathSample& at : sample(result.path, risk, kPathStep)) {
    const std::string alpha = std::isnan(at.alpha) ? "" : to_text(at.alpha);
    text += to_text(at.pose.x) + ',' + to_text(at.pose.y) + ',' + to_text(at.pose.yaw) + ',' + to_text(at.s) + ',' + alpha + ',' +
            to_text(at.risk);
    for (std::size_t i = 0; i < sources.size(); ++i) text.append(",").append(to_text(risk.layers()[i].at(at.pose)));
    text += '\n';
  }
  write_file(csv, text);
}

void print_figures(const PathFigures& figures, const RiskOptions& risk) {
  std::printf("%-20s %9.2f m\n%-20s %9.2f m\n", "length", figures.length, "risk integral", figures.risk_integral);
  const std::vector<std::string> sources = source_labels(risk, "risk, ");
  for (std::size_t i = 0; i < sources.size(); ++i) std::printf("%-20s %9.2f m\n", sources[i].c_str(), figures.risk_by_source[i]);
  std::printf("%-20s %9.2f m\n%-20s %9.2f m\n", "blind", figures.blind_length, "longest blind", figures.longest_blind);
  std::printf("%-20s %9.3f\n%-20s %9.3f\n", "alpha, mean", figures.alpha_mean, "alpha, least", figures.alpha_min);
}

std::vector<std::string> source_labels(const RiskOptions& risk, const std::string& prefix) {
  std::vector<std::string> labels;
  if (risk.sources.empty()) return labels;
  for (const std::string& name : names_of_risks(risk)) labels.push_back(prefix + name);
  return labels;
}

DrawnPath drawn(const PlanResult& result, const RiskField& risk, const std::string& name, Colour colour, LineStyle style) {
  char figures[64];
  std::snprintf(figures, sizeof figures, ": %.1f m, %.1f m blind", result.figures.length, result.figures.blind_length);
  DrawnPath path{.label = name + figures, .poses = result.path, .profile = {}, .colour = colour, .style = style};
  for (const PathSample& at : sample(result.path, risk, kPathStep)) path.profile.push_back({at.s, at.alpha});
  return path;
}

PathPictureOptions picture_options(const PlanQuery& query, const RiskField& risk, const GridGeometry& map, const std::string& title) {
  PathPictureOptions options{.title = title,
                             .risk = query.risk,
                             .start = query.start,
                             .goal = query.goal,
                             .robot_radius = query.robot.radius,
                             .footprint = query.robot.footprint};
  if (!risk.options().sources.empty()) options.risk_map = drawn_risk(risk, map);
  return options;
}

int say_no(const std::filesystem::path& problem_file, const PlanResult& result) {
  std::cerr << problem_file.string() << ": " << explanation(result.status);
  if (result.smallest_max_error) std::cerr << "; one was found with --max-error " << hundredths_up(*result.smallest_max_error);
  if (result.smallest_max_blind_distance) {
    std::cerr << "; one was found with --max-blind-distance " << hundredths_up(*result.smallest_max_blind_distance);
  }
  if (result.greatest_min_alpha) std::cerr << "; one was found with --min-alignability " << to_text(*result.greatest_min_alpha);
  std::cerr << '\n';
  return kNo;
}

}  // namespace alignability::cli
