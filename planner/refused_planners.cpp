// SPDX-License-Identifier: BSD-3-Clause
#include "planner/refused_planners.hpp"

#include <algorithm>

namespace alignability {
namespace {

constexpr const char* kStraightLine =
    "it discards places by the straight line's length from the start, which no cost map keeps to, and so may discard the best path; take "
    "rrtstar";
constexpr const char* kIgnores = "it ignores the objective and returns the first path it finds; take rrtstar or bitstar";
constexpr const char* kByLength = "it measures by the state space's distance, not by the objective; take prmstar or rrtstar";
constexpr const char* kTransitionTest =
    "it weighs the cost of places in a random test and keeps the first path, at whatever cost; take rrtstar or bitstar";

struct Refusal {
  const char* name;
  const char* reason;
};

constexpr Refusal kRefusals[] = {
    {"informedrrtstar", kStraightLine},
    {"sorrtstar", kStraightLine},
    {"anytimepathshortening", "it shortens paths by length, and so back into the aisles that the objective shuns; take rrtstar"},
    {"aitstar", "it may abort the program, by an assertion in OMPL 1.5.2's forward search; take bitstar or abitstar"},
    {"lbtrrt", kByLength},
    {"lazylbtrrt", kByLength},
    {"spars", kByLength},
    {"sparstwo", kByLength},
    {"trrt", kTransitionTest},
    {"bitrrt", kTransitionTest},
    {"sst", "it drives by random steps and seldom ends within the goal's tolerance; take rrtstar"},
    {"vfrrt", "it follows a vector field, which an objective does not give; take rrtstar"},
    {"tsrrt", "it needs a task space of its own; take rrtstar"},
    {"xxl", "it needs a decomposition of the space; take prmstar"},
    {"qrrt", "it needs a sequence of spaces; take rrtstar"},
    {"lightning", "it needs paths of earlier queries; take prmstar"},
    {"thunder", "it needs paths of earlier queries; take prmstar"},
    {"rrt", kIgnores},
    {"rrtconnect", kIgnores},
    {"lazyrrt", kIgnores},
    {"prrt", kIgnores},
    {"est", kIgnores},
    {"biest", kIgnores},
    {"projest", kIgnores},
    {"kpiece1", kIgnores},
    {"bkpiece1", kIgnores},
    {"lbkpiece1", kIgnores},
    {"pdst", kIgnores},
    {"sbl", kIgnores},
    {"psbl", kIgnores},
    {"stride", kIgnores},
    {"rlrt", kIgnores},
    {"birlrt", kIgnores},
};

constexpr const char* kTwoWayRoads = "its road map takes every motion for one that is the same either way; take field or rrtstar";
constexpr const char* kNeighboursByCost =
    "it finds neighbours by cost, which along curves is not the same both ways, and takes minutes over it; take field or bitstar";
constexpr const char* kSameBothWays = "it rewires by motions that it takes to be the same both ways; take field or rrtstar";

// Where motions are curves: what they cost one way is not what they cost the other, if there is one.
constexpr Refusal kCurveRefusals[] = {
    {"prm", kTwoWayRoads},          {"prmstar", kTwoWayRoads},       {"lazyprm", kTwoWayRoads},   {"lazyprmstar", kTwoWayRoads},
    {"fmtstar", kNeighboursByCost}, {"bfmtstar", kNeighboursByCost}, {"rrtsharp", kSameBothWays}, {"rrtxstatic", kSameBothWays},
};

template <std::size_t N>
const char* reason_among(const Refusal (&refusals)[N], const std::string& name) {
  const auto* found = std::ranges::find(refusals, name, &Refusal::name);
  return found == std::end(refusals) ? nullptr : found->reason;
}

}  // namespace

const char* reason_against(const std::string& name) { return reason_among(kRefusals, name); }

const char* reason_against(const std::string& name, MotionSpace space) {
  return is_curved(space) ? reason_among(kCurveRefusals, name) : nullptr;
}

std::vector<std::string> refused_planner_names() {
  std::vector<std::string> names;
  for (const Refusal& refusal : kRefusals) names.emplace_back(refusal.name);
  return names;
}

}  // namespace alignability
