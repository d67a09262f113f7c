// SPDX-License-Identifier: BSD-3-Clause
#include "cli/compare_maps_output.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>

#include "core/range.hpp"

namespace alignability::cli {
namespace {

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json cell_json(const ComparedCell& cell) {
  return {{"x", cell.center.x()},
          {"y", cell.center.y()},
          {"first", cell.first},
          {"second", cell.second},
          {"difference", cell.difference()},
          {"chance", number(cell.chance)},
          {"lower", cell.is_lower}};
}

Json crossings_json(double threshold, const Crossings& crossings) {
  return {{"threshold", threshold}, {"fell", crossings.fell}, {"rose", crossings.rose}};
}

// Digits enough for an alignability, and its sign.
std::string change(double value) {
  std::string text = fixed_text(value, 3);
  return value > 0.0 ? text.insert(0, 1, '+') : text;
}

void print_crossings(const char* name, double threshold, const Crossings& crossings) {
  std::cout << name << to_text(threshold) << ": " << crossings.fell << " cells fell below, " << crossings.rose << " rose\n";
}

}  // namespace

Json comparison_json(const MapComparison& comparison, const MapComparisonOptions& options, std::size_t worst) {
  const Distribution& difference = comparison.difference;
  const Distribution& magnitude = comparison.magnitude;
  Json json{{"cells_first", comparison.in_first},
            {"cells_second", comparison.in_second},
            {"cells", comparison.cells.size()},
            {"difference", {{"min", difference.min}, {"mean", difference.mean}, {"median", difference.median}, {"max", difference.max}}},
            {"magnitude", {{"median", magnitude.median}, {"p95", magnitude.p95}, {"max", magnitude.max}}},
            {"rank_correlation", number(comparison.rank_correlation)},
            {"critical", crossings_json(options.alpha_critical, comparison.critical)},
            {"safe", crossings_json(options.alpha_safe, comparison.safe)},
            {"margin", options.margin},
            {"tested", comparison.is_tested},
            {"lower", comparison.lower},
            {"lower_as_whole", {{"value", comparison.is_lower_as_whole}, {"chance", comparison.chance}}},
            {"lower_cells", Json::array()},
            {"worst", Json::array()}};
  for (const ComparedCell& cell : comparison.cells) {
    if (cell.is_lower) json["lower_cells"].push_back(cell_json(cell));
  }
  for (std::size_t i = 0; i < std::min(worst, comparison.cells.size()); ++i) json["worst"].push_back(cell_json(comparison.cells[i]));
  return json;
}

void print_comparison(const MapComparison& comparison, const MapComparisonOptions& options, std::size_t worst, const std::string& first,
                      const std::string& second) {
  const Distribution& difference = comparison.difference;
  const Distribution& magnitude = comparison.magnitude;
  std::cout << "cells: " << comparison.in_first << " in " << first << ", " << comparison.in_second << " in " << second << ", "
            << comparison.cells.size() << " in both\n"
            << "change of alpha: median " << change(difference.median) << ", from " << change(difference.min) << " to "
            << change(difference.max) << '\n'
            << "without sign: median " << fixed_text(magnitude.median, 3) << ", 95 % " << fixed_text(magnitude.p95, 3) << ", max "
            << fixed_text(magnitude.max, 3) << '\n'
            << "rank correlation: " << fixed_text(comparison.rank_correlation, 3) << '\n';
  print_crossings("alpha critical, ", options.alpha_critical, comparison.critical);
  print_crossings("alpha safe, ", options.alpha_safe, comparison.safe);
  std::cout << "lower than chance explains: " << (comparison.is_tested ? std::to_string(comparison.lower) + " cells\n" : "not tested\n")
            << "lower as a whole: " << (comparison.is_lower_as_whole ? "yes\n" : "no\n");
  if (worst == 0) return;
  std::cout.flush();
  std::printf("%9s %9s %9s %9s %9s\n", "x", "y", "first", "second", "change");
  for (std::size_t i = 0; i < std::min(worst, comparison.cells.size()); ++i) {
    const ComparedCell& cell = comparison.cells[i];
    std::printf("%9.2f %9.2f %9.3f %9.3f %9s%s\n", cell.center.x(), cell.center.y(), cell.first, cell.second,
                change(cell.difference()).c_str(), cell.is_lower ? "  lower" : "");
  }
  std::fflush(stdout);
}

}  // namespace alignability::cli
