// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <span>

#include "cli/output_name.hpp"
#include "planner/random_pairs.hpp"

namespace alignability::cli {

/// A line of the table: a figure of both paths, and what the second has of the first.
void print_row(const char* name, double shortest, double risk_aware, const char* unit);

void print_table(const Comparison& comparison);
/// A row a weight, for --weights.
void print_curve(std::span<const PlanResult> curve);
/// A row a limit, after one of the shortest path, for --blind-limits.
void print_limits(const PlanResult& shortest, std::span<const PlanResult> limited);
/// Quantiles over the pairs that both plans solved, for --pairs.
void print_distribution(std::span<const Comparison> pairs);

/// Blind metres against length, a point a weight whose plan found a path: NAME_curve.png, and other kinds likewise.
void draw_curve(std::span<const PlanResult> curve, const std::filesystem::path& name, const PictureKinds& kinds);
/// The shortest path and those within limits of blind metres, those alike once: NAME_limits.png.
void draw_limits(const PlanProblem& problem, const RiskField& risk, const PlanResult& shortest, std::span<const PlanResult> limited,
                 const std::filesystem::path& name, const PictureKinds& kinds);
/// How the ratio of lengths and the blind metres are distributed: NAME.png.
void draw_distribution(std::span<const Comparison> pairs, const std::filesystem::path& name, const PictureKinds& kinds);
/// A row a pair; figures are empty where there is no path.
void write_pairs_csv(std::span<const Comparison> pairs, const std::filesystem::path& csv);

}  // namespace alignability::cli
