// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "cli/json.hpp"

namespace alignability::cli {

/// What came of a site in a job of many.
struct SiteOutcome {
  std::string name;
  std::string status;  ///< built, kept or failed
  Json figures;        ///< as those of one map, and `blind`, the share of evaluated cells below α_critical; null where it failed
  std::string error;   ///< none unless it failed
};

/// The figures of a map in a job of many.
Json site_figures(const AlignabilityMap& map, double seconds, const std::vector<std::filesystem::path>& files);

/// An array, however many there are: of each site name, status, error, and the figures.
void print_sites_json(const std::vector<SiteOutcome>& outcomes);

/// A line a site, and how many there are of each status.
void print_sites(const std::vector<SiteOutcome>& outcomes);

}  // namespace alignability::cli
