// SPDX-License-Identifier: BSD-3-Clause
// sample_page plain|headings FILE: writes a page, and prints as JSON what the library says of what the page works out by itself.
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/report/sample_report.hpp"

namespace {

using namespace alignability;
using Json = nlohmann::ordered_json;

constexpr double kCritical = 0.3;
constexpr double kSafe = 0.65;

std::vector<Pose2> poses(const ReportedPath& path) {
  std::vector<Pose2> poses;
  for (const PathSample& at : path.samples) poses.push_back(at.pose);
  return poses;
}

Json figures_at_other_thresholds(const test::SampleReport& sample) {
  PlanProblem problem = sample.problem;
  problem.query.risk.alpha_critical = kCritical;
  problem.query.risk.alpha_safe = kSafe;
  const RiskField risk(problem.alignability, problem.occupancy, problem.query.risk);
  Json figures{{"critical", kCritical}, {"safe", kSafe}};
  for (const ReportedPath& path : sample.report.paths) {
    const PathFigures at = measure(poses(path), risk);
    figures[path.name] = {{"blind", at.blind_length}, {"longest_blind", at.longest_blind}, {"risk", at.risk_integral}};
  }
  return figures;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const test::SampleReport sample = std::string(argv[1]) == "headings" ? test::sample_report_by_heading() : test::sample_report();
  const RiskField risk = sample.risk();
  std::ofstream(argv[2]) << to_html(sample.report, sample.problem, risk);
  Json alphas = Json::array();
  for (const Eigen::Vector2d& at : {Eigen::Vector2d(10.0, 8.5), Eigen::Vector2d(3.3, 4.2), Eigen::Vector2d(12.6, 1.7)}) {
    Json by_heading = Json::array();
    for (int k = 0; k < 8; ++k) by_heading.push_back(risk.alpha(at.x(), at.y(), k * 0.25 * 3.14159265358979));
    alphas.push_back({{"x", at.x()}, {"y", at.y()}, {"alpha", by_heading}});
  }
  std::cout << Json{{"figures", figures_at_other_thresholds(sample)}, {"alphas", alphas}}.dump() << '\n';
}
