// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pictures/path_picture.hpp"
#include "planner/plan.hpp"

namespace alignability::cli {

/// Between the samples of a path in files and pictures [m], beside its own poses.
inline constexpr double kPathStep = 0.1;

/// x,y,yaw,s,alpha,risk and, where risk has several sources, risk_NAME of each: the path's own poses and others between, at most 10 cm
/// apart.
void write_path_csv(const PlanResult& result, const RiskField& risk, const std::filesystem::path& csv);

/// What a path is worth, a line each, from the length on.
void print_figures(const PathFigures& figures, const RiskOptions& risk);

/// What makes a source's metres in tables and files: "risk, clearance", "risk_clearance". None where alignability is the only source.
std::vector<std::string> source_labels(const RiskOptions& risk, const std::string& prefix);

/// The path as a picture shows it, its figures in the label.
DrawnPath drawn(const PlanResult& result, const RiskField& risk, const std::string& name, Colour colour, LineStyle style);

/// With a map of the risk where it has several sources.
PathPictureOptions picture_options(const PlanQuery& query, const RiskField& risk, const GridGeometry& map, const std::string& title);

/// Tells on stderr why there is no path; the exit code.
int say_no(const std::filesystem::path& problem_file, const PlanResult& result);

}  // namespace alignability::cli
