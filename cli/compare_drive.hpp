// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "cli/drive_paths.hpp"
#include "cli/drive_site.hpp"
#include "cli/json.hpp"

namespace alignability::cli {

/// A comparison, driven: errors of one localizer along both paths, each run with the same errors on both.
struct DrivenComparison {
  Localizer localizer;
  LocalizerErrors shortest;
  LocalizerErrors risk_aware;
};

/// By comparison, then by localizer. All must be solved. Throws Interrupted.
std::vector<std::vector<DrivenComparison>> drive_comparisons(std::span<const Comparison> comparisons, const DriveSite& site, int runs,
                                                             const ClearanceMap& clearance);

/// The pairs, as numbers, whose paths differ most in the integral of risk, the most first; of those that are solved.
std::vector<std::size_t> most_different(std::span<const Comparison> pairs, std::size_t count);

Json drive_json(std::span<const DrivenComparison> driven, int runs);

/// The rows below those of print_table.
void print_drive(std::span<const DrivenComparison> driven, int runs);
/// A line a pair.
void print_driven_pairs(std::span<const Comparison> pairs, std::span<const std::size_t> chosen,
                        std::span<const std::vector<DrivenComparison>> driven, int runs);

}  // namespace alignability::cli
