// SPDX-License-Identifier: BSD-3-Clause
#include "cli/report_output.hpp"

#include <algorithm>
#include <cstdio>

#include "cli/path_output.hpp"
#include "core/range.hpp"

namespace alignability::cli {
namespace {

std::string shell_word(const std::string& word) {
  const auto is_plain = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || std::string_view("_-./,:=+@%").find(c) != std::string_view::npos;
  };
  if (!word.empty() && std::ranges::all_of(word, is_plain)) return word;
  std::string quoted = "'";
  for (const char c : word) c == '\'' ? quoted.append("'\\''") : quoted.append(1, c);
  return quoted + '\'';
}

// What makes one plan of a problem differ from another.
std::string name_of(const PlanResult& result) {
  if (result.query.max_blind_distance) return "at most " + to_text(*result.query.max_blind_distance) + " m blind";
  return "weight " + to_text(result.query.weight);
}

}  // namespace

std::string shell_line(std::span<const std::string> words) {
  std::string line;
  for (const std::string& word : words) line.append(line.empty() ? "" : " ").append(shell_word(word));
  return line;
}

ReportedPath reported(const PlanResult& result, const RiskField& risk, const std::string& name) {
  return {.name = name,
          .samples = sample(result.path, risk, kPathStep),
          .figures = result.figures,
          .cost = result.cost,
          .bound = result.lower_bound,
          .planning_seconds = result.seconds};
}

std::vector<ReportedPath> reported(const Comparison& comparison, std::span<const DrivenComparison> driven, int runs,
                                   std::span<const PlanResult> further, const RiskField& risk) {
  std::vector<ReportedPath> paths{reported(comparison.shortest, risk, "shortest"), reported(comparison.risk_aware, risk, "risk-aware")};
  paths[0].colour = kShortestColour;
  paths[0].style = LineStyle::dashed;
  for (const DrivenComparison& by : driven) {
    paths[0].errors.push_back(reported_errors(by.shortest, by.localizer, runs));
    paths[1].errors.push_back(reported_errors(by.risk_aware, by.localizer, runs));
  }
  const auto same_as = [](const PlanResult& plan) { return [&plan](const PlanResult* other) { return other->path == plan.path; }; };
  std::vector<const PlanResult*> known{&comparison.shortest, &comparison.risk_aware};
  for (const PlanResult& plan : further) {
    if (plan.status != PlanStatus::solved || std::ranges::any_of(known, same_as(plan))) continue;
    paths.push_back(reported(plan, risk, name_of(plan)));
    paths.back().colour = route_colour(known.size());
    known.push_back(&plan);
  }
  return paths;
}

std::string summary_of(const Comparison& comparison) {
  char text[256];
  std::snprintf(text, sizeof text,
                "The risk-aware path is %.2f times as long as the shortest, %.1f m for %.1f m, and drives %.1f m blind for %.1f m.",
                length_ratio(comparison), comparison.risk_aware.figures.length, comparison.shortest.figures.length,
                comparison.risk_aware.figures.blind_length, comparison.shortest.figures.blind_length);
  return text;
}

ReportedErrors reported_errors(const LocalizerErrors& errors, Localizer localizer, int runs) {
  ReportedErrors reported{.localizer = to_string(localizer),
                          .runs = runs,
                          .mean = errors.over_all.mean.value,
                          .p95 = errors.over_all.p95.value,
                          .max = errors.over_all.max.value,
                          .goal = errors.over_all.goal.value,
                          .lost = errors.over_all.lost.value,
                          .profile = {}};
  for (const ErrorAlong& at : errors.along) reported.profile.push_back({at.s, at.mean, at.p95});
  return reported;
}

std::vector<ReportedOptions> reported_options(const PlanProblem& problem) {
  std::vector<ReportedOptions> texts{{"The problem, defaults written out", to_yaml(problem.query)}};
  const AlignabilityMap& map = problem.alignability;
  if (!map.options.empty()) texts.push_back({"Options of the alignability map", map.options});
  if (!map.sensor.empty()) texts.push_back({"Sensor", map.sensor});
  if (!map.provenance.empty()) texts.push_back({"What the alignability map was made from", map.provenance});
  return texts;
}

}  // namespace alignability::cli
