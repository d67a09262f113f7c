// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>

#include "planner/alignability_objective.hpp"
#include "planner/drivable_area.hpp"
#include "planner/path_limits.hpp"
#include "planner/pose_goal.hpp"

namespace alignability {

/// States under a car's limits that differ by less than such a share of what is allowed count as one.
inline constexpr double kAlikeToCars = 0.02;

/// Where a car is to get, and by what: the curves of the objective's steering, which it must have.
struct CarTask {
  const DrivableArea& area;
  const AlignabilityObjective& objective;
  Pose2 start;
  Pose2 goal;
  GoalTolerance tolerance;
  PathLimits limits = {};  ///< kept all along
};

/// From pose to pose by a curve.
struct CarLeg {
  Curve curve;
  double cost;
};

/// The curve from one pose to another, if it costs less than that much and the robot gets along it.
inline std::optional<CarLeg> leg_below(double cost, const CarTask& task, const Pose2& from, const Pose2& to) {
  const auto curve = (*task.objective.steering())(from, to);
  if (!curve || curve->length() >= cost) return std::nullopt;
  const double own = task.objective.cost_of(*curve);
  if (!(own < cost) || !task.area.contains(*curve)) return std::nullopt;
  return CarLeg{*curve, own};
}

}  // namespace alignability
