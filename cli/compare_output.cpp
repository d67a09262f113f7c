// SPDX-License-Identifier: BSD-3-Clause
#include "cli/compare_output.hpp"

#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include "cli/output_name.hpp"
#include "cli/path_output.hpp"
#include "core/distribution.hpp"
#include "core/file.hpp"
#include "core/range.hpp"
#include "pictures/distribution_picture.hpp"
#include "pictures/trade_off_picture.hpp"

namespace alignability::cli {
namespace {

using Figure = double (*)(const Comparison&);

std::vector<double> over_pairs(std::span<const Comparison> pairs, Figure figure) {
  std::vector<double> values;
  for (const Comparison& pair : pairs) {
    if (solved(pair)) values.push_back(figure(pair));
  }
  return values;
}

void print_quantiles(const char* name, std::vector<double> values, const char* unit) {
  const Distribution d = distribution_of(std::move(values));
  std::printf("%-26s %9.2f %9.2f %9.2f %9.2f %9.2f %s\n", name, d.mean, d.min, d.median, d.p95, d.max, unit);
}

double shortest_blind(const Comparison& pair) { return pair.shortest.figures.blind_length; }
double risk_aware_blind(const Comparison& pair) { return pair.risk_aware.figures.blind_length; }
double shortest_length(const Comparison& pair) { return pair.shortest.figures.length; }
double risk_aware_length(const Comparison& pair) { return pair.risk_aware.figures.length; }
double shortest_risk(const Comparison& pair) { return pair.shortest.figures.risk_integral; }
double risk_aware_risk(const Comparison& pair) { return pair.risk_aware.figures.risk_integral; }

std::string csv_pose(const Pose2& at) { return to_text(at.x) + ',' + to_text(at.y) + ',' + to_text(at.yaw); }

std::string csv_figures(const PlanResult& result) {
  const PathFigures& figures = result.figures;
  if (result.status != PlanStatus::solved) return std::string(to_string(result.status)) + ",,,,";
  return std::string(to_string(result.status)) + ',' + to_text(figures.length) + ',' + to_text(figures.blind_length) + ',' +
         to_text(figures.longest_blind) + ',' + to_text(figures.risk_integral);
}

std::string metres(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f m", value);
  return text;
}

std::string least_that_does(const PlanResult& result) {
  if (!result.smallest_max_blind_distance) return "";
  return "; with " + metres(*result.smallest_max_blind_distance) + " there is one";
}

std::string limit_text(const PlanResult& result) { return "at most " + to_text(*result.query.max_blind_distance) + " m blind"; }

}  // namespace

void print_row(const char* name, double shortest, double risk_aware, const char* unit) {
  char relative[32] = "";
  if (shortest > 0.0) std::snprintf(relative, sizeof relative, "%6.2f x", risk_aware / shortest);
  std::printf("%-18s %10.2f %-2s %10.2f %-2s %10s\n", name, shortest, unit, risk_aware, unit, relative);
}

void print_table(const Comparison& comparison) {
  const PathFigures& a = comparison.shortest.figures;
  const PathFigures& b = comparison.risk_aware.figures;
  std::printf("%-18s %10s    %10s    %10s\n", "", "shortest", "risk-aware", "relative");
  print_row("length", a.length, b.length, "m");
  print_row("blind", a.blind_length, b.blind_length, "m");
  print_row("longest blind", a.longest_blind, b.longest_blind, "m");
  print_row("risk integral", a.risk_integral, b.risk_integral, "m");
  const std::vector<std::string> sources = source_labels(comparison.shortest.query.risk, "risk, ");
  for (std::size_t i = 0; i < sources.size(); ++i) print_row(sources[i].c_str(), a.risk_by_source[i], b.risk_by_source[i], "m");
  print_row("alpha, mean", a.alpha_mean, b.alpha_mean, "");
  print_row("alpha, least", a.alpha_min, b.alpha_min, "");
  print_row("planning", comparison.shortest.seconds, comparison.risk_aware.seconds, "s");
}

void print_curve(std::span<const PlanResult> curve) {
  std::printf("%8s %11s %11s %14s %14s %11s\n", "weight", "length", "blind", "longest blind", "risk integral", "detour");
  for (const PlanResult& point : curve) {
    if (point.status != PlanStatus::solved) {
      std::printf("%8g %s\n", point.query.weight, to_string(point.status));
      continue;
    }
    const PathFigures& figures = point.figures;
    std::printf("%8g %9.2f m %9.2f m %12.2f m %12.2f m %9.2f m\n", point.query.weight, figures.length, figures.blind_length,
                figures.longest_blind, figures.risk_integral, figures.length - curve.front().figures.length);
  }
}

void print_limits(const PlanResult& shortest, std::span<const PlanResult> limited) {
  std::printf("%10s %11s %11s %14s %21s %11s\n", "limit", "length", "blind", "longest blind", "longest unrecovered", "detour");
  const auto print_row_of = [&](const std::string& limit, const PlanResult& result, const std::string& unrecovered) {
    const PathFigures& figures = result.figures;
    std::printf("%10s %9.2f m %9.2f m %12.2f m %21s %9.2f m\n", limit.c_str(), figures.length, figures.blind_length, figures.longest_blind,
                unrecovered.c_str(), figures.length - shortest.figures.length);
  };
  print_row_of("none", shortest, "");
  for (const PlanResult& result : limited) {
    const std::string limit = to_text(*result.query.max_blind_distance) + " m";
    if (result.status == PlanStatus::solved) {
      print_row_of(limit, result, metres(*result.longest_unrecovered));
    } else {
      std::printf("%10s %s%s\n", limit.c_str(), to_string(result.status), least_that_does(result).c_str());
    }
  }
}

void print_distribution(std::span<const Comparison> pairs) {
  std::size_t both = 0;
  for (const Comparison& pair : pairs) both += solved(pair) ? 1 : 0;
  std::printf("%zu pairs, %zu of them solved for both\n", pairs.size(), both);
  if (both == 0) return;
  std::printf("%-26s %9s %9s %9s %9s %9s\n", "", "mean", "min", "median", "95 %", "max");
  print_quantiles("length ratio", over_pairs(pairs, length_ratio), "x");
  print_quantiles("length, shortest", over_pairs(pairs, shortest_length), "m");
  print_quantiles("length, risk-aware", over_pairs(pairs, risk_aware_length), "m");
  print_quantiles("blind, shortest", over_pairs(pairs, shortest_blind), "m");
  print_quantiles("blind, risk-aware", over_pairs(pairs, risk_aware_blind), "m");
  print_quantiles("risk integral, shortest", over_pairs(pairs, shortest_risk), "m");
  print_quantiles("risk integral, risk-aware", over_pairs(pairs, risk_aware_risk), "m");
}

void draw_curve(std::span<const PlanResult> curve, const std::filesystem::path& name, const PictureKinds& kinds) {
  std::vector<TradeOffPoint> points;
  for (const PlanResult& point : curve) {
    if (point.status == PlanStatus::solved) points.push_back({point.query.weight, point.figures.length, point.figures.blind_length});
  }
  for (const auto& file : picture_files(with_ending(name, "_curve"), kinds)) draw_trade_off(points, "What a longer path buys", file);
}

void draw_limits(const PlanProblem& problem, const RiskField& risk, const PlanResult& shortest, std::span<const PlanResult> limited,
                 const std::filesystem::path& name, const PictureKinds& kinds) {
  std::vector<DrawnPath> routes;
  const PlanResult* last = nullptr;
  for (const PlanResult& result : limited) {
    if (result.status != PlanStatus::solved || (last != nullptr && last->cost == result.cost)) continue;
    routes.push_back(drawn(result, risk, limit_text(result), route_colour(routes.size() + 1), LineStyle::solid));
    last = &result;
  }
  routes.push_back(drawn(shortest, risk, "shortest", kShortestColour, LineStyle::dashed));
  const PathPictureOptions picture = picture_options(problem.query, risk, problem.occupancy.geometry(), name.filename().string());
  for (const auto& file : picture_files(with_ending(name, "_limits"), kinds)) {
    draw_paths(problem.alignability, problem.occupancy, routes, picture, file);
  }
}

void draw_distribution(std::span<const Comparison> pairs, const std::filesystem::path& name, const PictureKinds& kinds) {
  const std::array panels{
      DistributionPanel{"length, risk-aware / shortest", {{"", over_pairs(pairs, length_ratio), kRiskAwareColour, LineStyle::solid}}, 1.0},
      DistributionPanel{"driven blind [m]",
                        {{"shortest", over_pairs(pairs, shortest_blind), kShortestColour, LineStyle::dashed},
                         {"risk-aware", over_pairs(pairs, risk_aware_blind), kRiskAwareColour, LineStyle::solid}},
                        0.0}};
  const std::string title = std::to_string(panels.front().curves.front().values.size()) + " random pairs of start and goal";
  for (const auto& file : picture_files(name, kinds)) draw_distributions(panels, title, file);
}

void write_pairs_csv(std::span<const Comparison> pairs, const std::filesystem::path& csv) {
  std::string text = "start_x,start_y,start_yaw,goal_x,goal_y,goal_yaw";
  for (const char* path : {"shortest", "risk_aware"}) {
    for (const char* figure : {"status", "length", "blind_length", "longest_blind", "risk_integral"}) {
      text += std::string(",") + path + '_' + figure;
    }
  }
  text += '\n';
  for (const Comparison& pair : pairs) {
    const PlanQuery& query = pair.shortest.query;
    text +=
        csv_pose(query.start) + ',' + csv_pose(query.goal) + ',' + csv_figures(pair.shortest) + ',' + csv_figures(pair.risk_aware) + '\n';
  }
  write_file(csv, text);
}

}  // namespace alignability::cli
