// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planner/plan_problem.hpp"

namespace alignability::test {

inline const ErrorModel kModel{.growth = 0.02, .recovery = 2.0, .least = 0.02, .alpha_poor = 0.1, .alpha_rich = 0.4, .calibration = {}};

/// 30 × 12 m, free. α is poor but for three rows of rich ground: along the bottom, along the top, and an island in the middle.
inline PlanProblem problem_with_an_island() {
  PlanProblem problem{OccupancyMap(Grid<float>({.resolution = 0.1, .width = 300, .height = 120}, 0.0f)), {}, {}};
  problem.alignability.geometry = {.resolution = 1.0, .width = 30, .height = 12};
  Grid<float> alpha(problem.alignability.geometry, 0.02f);
  for (int x = 0; x < 30; ++x) alpha[Cell{x, 0}] = alpha[Cell{x, 1}] = 0.6f;
  for (int x = 11; x < 19; ++x) {
    for (int y = 6; y < 9; ++y) alpha[Cell{x, y}] = 0.6f;
  }
  for (int x : {0, 1, 2, 27, 28, 29}) {
    for (int y = 0; y < 12; ++y) alpha[Cell{x, y}] = 0.6f;
  }
  problem.alignability.layers = {{"alpha", alpha}};
  problem.alignability.error_model = kModel;
  problem.query.robot.radius = 0.3;
  problem.query.motion.space = MotionSpace::r2;
  problem.query.start = {1.5, 10.5, 0.0};
  problem.query.goal = {28.5, 10.5, 0.0};
  problem.query.weight = 0.0;
  return problem;
}

}  // namespace alignability::test
