// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ompl/base/Planner.h>
#include <ompl/geometric/PathGeometric.h>

#include <cstdint>
#include <memory>
#include <optional>

#include "planner/drivable_area.hpp"

namespace alignability {

/// Plans by the optimal cost-to-go over the plane: marches it from the goal, follows it down from the start, refines the path off the
/// lattice by the exact cost, and returns; no sampling, no seed, the same path every time. Headings: a disk turns evenly, or,
/// where risk depends on heading, along the path that is best facing anywhere as is cheapest, and in R², facing ahead, takes the path that
/// is found by what each motion costs in its direction; a footprint is
/// taken along the plane's best paths for disks from the inscribed to the circumscribed one, with headings found by search, of which the
/// cheapest counts. A car's path is searched for over poses (see search_car_path) and refined. Where no path comes of it (a footprint that
/// must turn where the plane knows nothing of it), BIT* goes on until the termination condition.
///
/// In R², SE(2), Dubins and Reeds-Shepp spaces, one start and one goal state (a PoseGoal's tolerance is used), with a DrivabilityChecker
/// and an AlignabilityObjective. The termination condition is asked every millisecond or so.
class FieldPlanner : public ompl::base::Planner {
 public:
  explicit FieldPlanner(const ompl::base::SpaceInformationPtr& si);

  /// How often BIT* asks the termination condition at most, where it goes on; as often as it likes without.
  void set_search_iterations(std::int64_t most) { search_iterations_ = most; }

  /// Throws ompl::Exception where the checker or the objective is another.
  void setup() override;
  ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition& until) override;
  using ompl::base::Planner::solve;
  void clear() override;
  /// The path's states and motions, or BIT*'s graph.
  void getPlannerData(ompl::base::PlannerData& data) const override;

 private:
  ompl::base::PlannerStatus add_path() const;
  ompl::base::PlannerStatus search_on(const ompl::base::PlannerTerminationCondition& until);

  std::shared_ptr<ompl::geometric::PathGeometric> path_;
  ompl::base::PlannerPtr search_;
  std::optional<std::int64_t> search_iterations_;
};

}  // namespace alignability
