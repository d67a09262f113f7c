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

constexpr double kStep = 0.1;

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

// Rounded up, so that it will do.
std::string hundredths_up(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", std::ceil(100.0 * value) / 100.0);
  return text;
}

}  // namespace

void write_path_csv(const PlanResult& result, const RiskField& risk, const std::filesystem::path& csv) {
  std::string text = "x,y,yaw,s,alpha,risk\n";
  for (const PathSample& at : sample(result.path, risk, kStep)) {
    const std::string alpha = std::isnan(at.alpha) ? "" : to_text(at.alpha);
    text += to_text(at.pose.x) + ',' + to_text(at.pose.y) + ',' + to_text(at.pose.yaw) + ',' + to_text(at.s) + ',' + alpha + ',' +
            to_text(at.risk) + '\n';
  }
  write_file(csv, text);
}

void print_figures(const PathFigures& figures) {
  std::printf("%-20s %9.2f m\n%-20s %9.2f m\n", "length", figures.length, "risk integral", figures.risk_integral);
  std::printf("%-20s %9.2f m\n%-20s %9.2f m\n", "blind", figures.blind_length, "longest blind", figures.longest_blind);
  std::printf("%-20s %9.3f\n%-20s %9.3f\n", "alpha, mean", figures.alpha_mean, "alpha, least", figures.alpha_min);
}

DrawnPath drawn(const PlanResult& result, const RiskField& risk, const std::string& name, Colour colour, LineStyle style) {
  char figures[64];
  std::snprintf(figures, sizeof figures, ": %.1f m, %.1f m blind", result.figures.length, result.figures.blind_length);
  DrawnPath path{.label = name + figures, .poses = result.path, .profile = {}, .colour = colour, .style = style};
  for (const PathSample& at : sample(result.path, risk, kStep)) path.profile.push_back({at.s, at.alpha});
  return path;
}

PathPictureOptions picture_options(const PlanQuery& query, const std::string& title) {
  return {.title = title,
          .risk = query.risk,
          .start = query.start,
          .goal = query.goal,
          .robot_radius = query.robot.radius,
          .footprint = query.robot.footprint};
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
