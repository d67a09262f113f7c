// SPDX-License-Identifier: BSD-3-Clause
#include "planner/car_path.hpp"

#include "planner/car_refinement.hpp"
#include "planner/car_search.hpp"

namespace alignability {

std::optional<std::vector<Pose2>> car_path(const CarTask& task, const StopTest& stop) {
  const auto lattice = std::make_shared<const CostLattice>(*task.area.risk_field(), *task.area.clearance_map(),
                                                           task.objective.options().weight, task.area.inscribed_radius(), stop);
  const CostBound to_go(lattice, task.goal.position(), 0.0, stop);
  auto poses = search_car_path(task, to_go, stop);
  if (!poses) return std::nullopt;
  return refined(std::move(*poses), task, stop);
}

std::vector<Curve> curves_through(std::span<const Pose2> poses, const Steering& steering) {
  std::vector<Curve> curves;
  for (std::size_t i = 1; i < poses.size(); ++i) curves.push_back(steering.word(poses[i - 1], poses[i]));
  return curves;
}

std::vector<Pose2> driven_poses(std::span<const Curve> curves, const DrivableArea& area) {
  return poses_along(curves, kLargestSagitta, [&](const Pose2& from, const Pose2& to) { return area.contains(from, to); });
}

}  // namespace alignability
