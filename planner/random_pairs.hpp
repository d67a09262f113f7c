// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "core/progress.hpp"
#include "planner/compare.hpp"
#include "planner/drivable_area.hpp"

namespace alignability {

struct PosePair {
  Pose2 start;
  Pose2 goal;
};

/// Pairs of poses drawn evenly over where the robot may be, headings too, between which no wall is proven to stand. The same seed gives the
/// same pairs. Throws std::runtime_error when in 100,000 draws on end the robot finds no place.
std::vector<PosePair> random_pairs(const DrivableArea& area, double goal_tolerance, std::size_t count, std::uint64_t seed);

struct PairOptions {
  std::size_t count = 0;
  std::uint64_t seed = 1;
  PlanOptions plan;
  ProgressCallback progress;
};

/// The query compared between random pairs in place of its own start and goal, in their order. Throws as plan and random_pairs do, and
/// Interrupted.
std::vector<Comparison> compare_pairs(const PlanQuery& query, const PlanningFields& fields, const PairOptions& options);

}  // namespace alignability
