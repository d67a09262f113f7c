// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pictures/error_profile_picture.hpp"
#include "planner/path_figures.hpp"
#include "planner/plan_problem.hpp"

namespace alignability {

/// How far off one localizer was over several drives of a path [m].
struct ReportedErrors {
  std::string localizer;
  int runs = 0;
  double mean = 0.0;
  double p95 = 0.0;
  double max = 0.0;
  double goal = 0.0;
  double lost = 0.0;                ///< share of the runs
  std::vector<ErrorPoint> profile;  ///< s ascending
};

struct ReportedPath {
  std::string name;                 ///< "risk-aware"
  std::vector<PathSample> samples;  ///< s ascending from 0, close to one another beside an α-cell
  PathFigures figures;              ///< exact; shown while the thresholds stand where the path was planned
  std::optional<double> cost = {};  ///< [equivalent m], and what no path costs less than
  std::optional<double> bound = {};
  std::optional<double> planning_seconds = {};
  Colour colour = kRiskAwareColour;  ///< on a light page; a dark one takes its lightness turned around
  LineStyle style = LineStyle::solid;
  std::vector<ReportedErrors> errors = {};  ///< one a localizer, the same ones for every path that was driven
};

/// A text to unfold: how the report came to be.
struct ReportedOptions {
  std::string title;
  std::string text;
};

struct Report {
  std::string title;
  std::string summary;  ///< a sentence or two; none when empty
  std::string command;  ///< that made it
  std::vector<ReportedPath> paths;
  std::vector<ReportedOptions> options;
};

/// One HTML file that holds all it shows and asks no network: the maps, with α or risk at thresholds that the reader moves, paths to switch
/// on and off, α and errors along them, their figures. In light and dark, for mouse, keyboard and touch. α is kept to 2⁻¹⁶; where a map has
/// more than 2048 cells on a side, walls are drawn by blocks, and α by the least of each block. Text that is no UTF-8 is mended.
std::string to_html(const Report& report, const PlanProblem& problem, const RiskField& risk);

}  // namespace alignability
