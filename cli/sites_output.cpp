// SPDX-License-Identifier: BSD-3-Clause
#include "cli/sites_output.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>

#include "cli/progress_bar.hpp"
#include "core/range.hpp"
#include "costmap/risk_field.hpp"

namespace alignability::cli {
namespace {

std::string median_text(const Json& figures) {
  const Json& median = figures["alpha"]["median"];
  return median.is_null() ? "-" : fixed_text(median, 3);
}

std::string blind_text(const Json& figures) {
  const Json& blind = figures["blind"];
  return blind.is_null() ? "-" : fixed_text(100.0 * blind.get<double>(), 1) + " %";
}

std::string time_text(const SiteOutcome& outcome) {
  return outcome.status == "kept" ? "kept" : duration_text(outcome.figures["seconds"].get<double>());
}

Json site_json(const SiteOutcome& outcome) {
  Json json{{"name", outcome.name}, {"status", outcome.status}, {"error", outcome.error.empty() ? Json(nullptr) : Json(outcome.error)}};
  if (!outcome.figures.is_null()) json.update(outcome.figures);
  return json;
}

}  // namespace

Json site_figures(const AlignabilityMap& map, double seconds, const std::vector<std::filesystem::path>& files) {
  Json figures = map_json(map, seconds, files);
  const double critical = RiskOptions{}.alpha_critical;
  const auto blind = std::ranges::count_if(map.alpha().values(), [&](float alpha) { return alpha < critical; });
  const double cells = figures["cells_evaluated"];
  figures["blind"] = cells > 0.0 ? Json(static_cast<double>(blind) / cells) : Json(nullptr);
  return figures;
}

void print_sites_json(const std::vector<SiteOutcome>& outcomes) {
  Json sites = Json::array();
  for (const SiteOutcome& outcome : outcomes) sites.push_back(site_json(outcome));
  std::cout << sites.dump(2) << '\n';
}

void print_sites(const std::vector<SiteOutcome>& outcomes) {
  std::size_t widest = 4;
  for (const SiteOutcome& outcome : outcomes) widest = std::max(widest, outcome.name.size());
  const int width = static_cast<int>(widest);
  std::printf("%-*s %10s %14s %8s %14s\n", width, "site", "cells", "alpha, median", "blind", "time");
  for (const SiteOutcome& outcome : outcomes) {
    if (outcome.status == "failed") {
      std::printf("%-*s     failed: %s\n", width, outcome.name.c_str(), outcome.error.c_str());
      continue;
    }
    const Json& figures = outcome.figures;
    std::printf("%-*s %10zu %14s %8s %14s\n", width, outcome.name.c_str(), figures["cells_evaluated"].get<std::size_t>(),
                median_text(figures).c_str(), blind_text(figures).c_str(), time_text(outcome).c_str());
  }
  const auto of = [&](const char* status) { return std::ranges::count(outcomes, status, &SiteOutcome::status); };
  std::printf("%td built, %td kept, %td failed\n", of("built"), of("kept"), of("failed"));
  std::fflush(stdout);
}

}  // namespace alignability::cli
