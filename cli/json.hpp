// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <vector>

#include "alignability/alignability.hpp"
#include "alignability/explanation.hpp"
#include "costmap/alignability_map.hpp"
#include "planner/compare.hpp"

namespace alignability::cli {

// The objects of `--json`: metres and seconds, null where there is no value.
using Json = nlohmann::ordered_json;

/// With the readings that were asked for.
Json score_json(const std::filesystem::path& file, const Alignability& score, const AlignabilityOptions& options, double seconds);
/// A key for each.
void add_readings(Json& json, const Readings& readings, std::span<const Reading> wanted);
Json explanation_json(const Pose2& at, const Explanation& explanation, Verdict verdict, const std::string& why);
Json map_json(const AlignabilityMap& map, double seconds, const std::vector<std::filesystem::path>& files);
/// [[x, y, yaw], …].
Json path_json(std::span<const Pose2> path);

Json plan_json(const PlanResult& result);
Json plans_json(std::span<const PlanResult> results);
Json compare_json(const Comparison& comparison);
/// Distributions over the pairs that both plans solved, and every pair without its paths.
Json pairs_json(std::span<const Comparison> pairs);

/// One object a line of output, or an array of them for several.
void print(const std::vector<Json>& objects);

}  // namespace alignability::cli
