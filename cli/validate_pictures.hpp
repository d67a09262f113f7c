// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <span>

#include "cli/output_name.hpp"
#include "localization/validation.hpp"
#include "planner/plan_problem.hpp"

namespace alignability::cli {

/// Of each localizer the error by cell, NAME_LOCALIZER_error.png, and error and growth against alignability, NAME_LOCALIZER_scatter.png.
void draw_error_maps(std::span<const Validation> validations, const PlanProblem& problem, const DrivenPath& path,
                     const std::filesystem::path& name, const PictureKinds& kinds);

/// Of each localizer the error along every path, NAME_LOCALIZER.png.
void draw_profiles(std::span<const Validation> validations, std::span<const DrivenPath> paths, const RiskField& risk,
                   const std::filesystem::path& name, const PictureKinds& kinds);

}  // namespace alignability::cli
