// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <span>

#include "cli/json.hpp"
#include "localization/trials.hpp"
#include "localization/validation.hpp"

namespace alignability::cli {

/// error {mean, p95, max}, goal_error, lost_share, unsafe_share, and the interval of each.
Json errors_json(const PathErrors& errors);
Json validation_json(const Validation& validation, std::span<const DrivenPath> paths, const TrialOptions& options,
                     const GridGeometry& cells);

void print_errors(const Validation& validation, std::span<const DrivenPath> paths);
void print_predictions(const Validation& validation);

/// x,y,…: the cells driven through, the map's readings there, error and growth of each localizer.
void write_cells_csv(std::span<const Validation> validations, const AlignabilityMap& map, const std::filesystem::path& csv);

}  // namespace alignability::cli
