// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "cli/compare_drive.hpp"
#include "planner/plan.hpp"
#include "report/report.hpp"

namespace alignability::cli {

/// The words of a command line as a shell takes them.
std::string shell_line(std::span<const std::string> words);

/// A plan that found a path.
ReportedPath reported(const PlanResult& result, const RiskField& risk, const std::string& name);

/// Both paths of a comparison that was solved, driven or not, and after them those of further plans that were solved and differ.
std::vector<ReportedPath> reported(const Comparison& comparison, std::span<const DrivenComparison> driven, int runs,
                                   std::span<const PlanResult> further, const RiskField& risk);

/// In a sentence, of paths that were solved.
std::string summary_of(const Comparison& comparison);

ReportedErrors reported_errors(const LocalizerErrors& errors, Localizer localizer, int runs);

/// The problem with defaults written out, and what the alignability map says of itself.
std::vector<ReportedOptions> reported_options(const PlanProblem& problem);

}  // namespace alignability::cli
