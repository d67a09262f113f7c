// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planner/plan_problem.hpp"

namespace alignability::test {

/// 20 × 10 m around a block: from the left to the right, above the block it is 16 m and blind, below it some 25 m and safe.
inline PlanProblem two_corridors() {
  Grid<float> occupancy({.resolution = 0.1, .origin = {0.0, 0.0}, .width = 200, .height = 100}, 0.0f);
  for (int y = 0; y < 100; ++y) {
    for (int x = 0; x < 200; ++x) {
      const bool border = x == 0 || y == 0 || x == 199 || y == 99;
      const bool block = x >= 40 && x < 160 && y >= 30 && y < 75;
      if (border || block) occupancy[Cell{x, y}] = 1.0f;
    }
  }
  Grid<float> alpha({.resolution = 1.0, .origin = {0.0, 0.0}, .width = 20, .height = 10}, 0.8f);
  for (int x = 4; x < 16; ++x) {
    for (int y = 7; y < 10; ++y) alpha[Cell{x, y}] = 0.02f;
  }
  PlanProblem problem{OccupancyMap(std::move(occupancy)), {}, {}};
  problem.alignability.geometry = alpha.geometry();
  problem.alignability.layers.push_back({"alpha", std::move(alpha)});
  problem.query.robot.radius = 0.4;
  problem.query.start = {2.0, 8.5, 0.0};
  problem.query.goal = {18.0, 8.5, 0.0};
  problem.query.goal_tolerance = {.position = 0.3, .heading = radians(20)};
  problem.query.planner = {.name = "", .time = 1.0, .iterations = std::nullopt, .seed = 1};
  return problem;
}

}  // namespace alignability::test
