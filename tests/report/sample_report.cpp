// SPDX-License-Identifier: BSD-3-Clause
#include "tests/report/sample_report.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "costmap/heading_layers.hpp"
#include "planner/headings.hpp"
#include "tests/planner/two_corridors.hpp"

namespace alignability::test {
namespace {

// α that changes from cell to cell, so that no threshold and no place is like another.
PlanProblem uneven_corridors() {
  PlanProblem problem = two_corridors();
  Grid<float>& alpha = problem.alignability.layers.front().values;
  for (std::size_t i = 0; i < alpha.values().size(); ++i) {
    const Cell cell = alpha.geometry().cell_of(i);
    alpha[i] *= static_cast<float>(0.75 + 0.25 * std::sin(1.7 * cell.x + 0.9 * cell.y));
  }
  for (int x = 17; x < 20; ++x) alpha[Cell{x, 0}] = std::numeric_limits<float>::quiet_NaN();
  return problem;
}

ReportedErrors errors(const std::string& localizer, double length, double growth) {
  ReportedErrors errors{
      .localizer = localizer, .runs = 4, .mean = growth * length / 2, .p95 = growth * length, .max = 1.2 * growth * length, .profile = {}};
  for (double s = 0.0; s < length; s += 0.5) errors.profile.push_back({s, growth * s, 1.5 * growth * s});
  return errors;
}

ReportedPath reported(const std::string& name, std::vector<Pose2> way, const RiskField& risk, double growth) {
  way = looking_ahead(std::move(way), 0.0);
  ReportedPath path{.name = name, .samples = sample(way, risk, 0.1), .figures = measure(way, risk)};
  path.errors = {errors("ndt_mcl_sum", path.figures.length, growth), errors("scan_matching", path.figures.length, 0.3 * growth)};
  return path;
}

SampleReport report_of(PlanProblem problem) {
  SampleReport sample{std::move(problem), {}};
  const RiskField risk = sample.risk();
  sample.report.title = "Two corridors & <a block>";
  sample.report.summary = "A summary.";
  sample.report.command = "alignability report 'two corridors.yaml'";
  sample.report.options = {{"The problem", "radius: 0.4 # </script>\n"}};
  sample.report.paths = {reported("shortest", {{2.0, 8.5, 0.0}, {18.0, 8.5, 0.0}}, risk, 0.05),
                         reported("risk-aware", {{2.0, 8.5, 0.0}, {2.3, 2.0, 0.0}, {17.7, 2.0, 0.0}, {18.0, 8.5, 0.0}}, risk, 0.004)};
  sample.report.paths.front().colour = kShortestColour;
  sample.report.paths.front().style = LineStyle::dashed;
  return sample;
}

}  // namespace

SampleReport sample_report() { return report_of(uneven_corridors()); }

SampleReport sample_report_by_heading() {
  constexpr std::size_t kHeadings = 8;
  PlanProblem problem = uneven_corridors();
  const Grid<float> alpha = problem.alignability.alpha();
  for (std::size_t k = 0; k < kHeadings; ++k) {
    Grid<float> at_heading = alpha;
    const double along = std::abs(std::cos(2.0 * std::numbers::pi * static_cast<double>(k) / kHeadings));
    for (std::size_t i = 0; i < alpha.values().size(); ++i) at_heading[i] *= static_cast<float>(1.0 - 0.7 * along);
    problem.alignability.layers.push_back({heading_layer_name(k), std::move(at_heading)});
  }
  return report_of(std::move(problem));
}

}  // namespace alignability::test
