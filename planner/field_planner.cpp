// SPDX-License-Identifier: BSD-3-Clause
#include "planner/field_planner.hpp"

#include <ompl/base/SpaceInformation.h>
#include <ompl/util/Exception.h>

#include "planner/alignability_objective.hpp"
#include "planner/car_path.hpp"
#include "planner/drivability.hpp"
#include "planner/goal_field.hpp"
#include "planner/heading_search.hpp"
#include "planner/planners.hpp"
#include "planner/pose_goal.hpp"
#include "planner/pose_refinement.hpp"
#include "planner/poses.hpp"

namespace alignability {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;
using PathPtr = std::shared_ptr<og::PathGeometric>;

struct Task {
  const DrivableArea& area;
  const AlignabilityObjective& objective;
  Pose2 start;
  Pose2 goal;
  GoalTolerance tolerance;
  bool faces_ahead;  // where it goes, as in R²
};

// Those of the disks that paths in the plane are made for.
std::vector<double> radii(const DrivableArea& area) {
  const double least = area.inscribed_radius();
  const double most = area.circumscribed_radius();
  if (least == most) return {least};
  return {most, 0.5 * (least + most), least};
}

// Over a lattice of motions that cost the same either way, whether or not the robot's do.
std::optional<PlanarPath> path_on_lattice(const PlanarMotion& motion, const Eigen::Vector2d& start, const Eigen::Vector2d& goal,
                                          const StopTest& stop) {
  if (motion.facing == Facing::anywhere) return steepest_path(motion, start, goal, stop);
  PlanarMotion either_way = motion;
  either_way.facing = Facing::anywhere;
  const GoalField field(std::make_shared<const DrivableLattice>(either_way, stop), goal, stop);
  return field.directed_path_from(start, motion, stop);
}

std::optional<PlanarPath> planar_path(const Task& task, const PlanarMotion& motion, const StopTest& stop) {
  const Eigen::Vector2d start = task.start.position();
  const Eigen::Vector2d goal = task.goal.position();
  if (!motion.is_allowed(start, start) || !motion.is_allowed(goal, goal)) return std::nullopt;
  const auto path = path_on_lattice(motion, start, goal, stop);
  if (!path) return std::nullopt;
  // Short of the limit by more than rounding, so that it is met.
  return cut_within(refined(*path, motion, stop), (1.0 - 1e-6) * task.tolerance.position);
}

// Whether it is of importance where the robot faces, beyond what turning costs.
bool depends_on_heading(const Task& task) {
  const RiskField& risk = *task.area.risk_field();
  return risk.has_headings() && (task.objective.options().weight > 0.0 || risk.options().min_alpha);
}

std::optional<std::vector<Pose2>> with_headings(const PlanarPath& path, const Task& task, double radius, const StopTest& stop) {
  const HeadingEnds ends{task.start.yaw, task.goal.yaw, task.tolerance.heading};
  if (depends_on_heading(task) && !task.faces_ahead) {
    const ObjectiveOptions& by = task.objective.options();
    auto poses = turning_clear(path, ends, task.area, {by.turn_cost, by.weight});
    return poses ? std::optional(refined(std::move(*poses), {task.area, by.weight, by.turn_cost}, stop)) : std::nullopt;
  }
  if (radius >= task.area.circumscribed_radius()) return turning_evenly(path, ends);
  return turning_clear(path, ends, task.area, {});
}

PathPtr as_states(const std::vector<Pose2>& poses, const ob::SpaceInformationPtr& si) {
  auto path = std::make_shared<og::PathGeometric>(si);
  ob::ScopedState<> state(si);
  for (const Pose2& pose : poses) {
    set_pose(*si->getStateSpace(), pose, state.get());
    path->append(state.get());
  }
  return path;
}

// nullptr where the plane's path for a disk of that radius makes none for the robot.
PathPtr path_for_disk(const Task& task, double radius, const ob::SpaceInformationPtr& si, const StopTest& stop) {
  const Facing facing = task.faces_ahead && depends_on_heading(task) ? Facing::ahead : Facing::anywhere;
  const PlanarMotion motion{task.area.risk_field(), task.area.clearance_map(), task.objective.options().weight, radius, facing};
  const auto planar = planar_path(task, motion, stop);
  if (!planar) return nullptr;
  const auto poses = with_headings(*planar, task, radius, stop);
  if (!poses) return nullptr;
  const PathPtr path = as_states(*poses, si);
  return path->check() ? path : nullptr;
}

// Throws Interrupted where there is none yet.
PathPtr best_path_of_disks(const Task& task, const ob::ProblemDefinitionPtr& problem, const StopTest& stop) {
  const ob::OptimizationObjectivePtr& objective = problem->getOptimizationObjective();
  const ob::SpaceInformationPtr& si = problem->getSpaceInformation();
  PathPtr best;
  for (const double radius : radii(task.area)) {
    try {
      const PathPtr path = path_for_disk(task, radius, si, stop);
      if (path && (!best || path->cost(objective).value() < best->cost(objective).value())) best = path;
    } catch (const Interrupted&) {
      if (!best) throw;
      break;
    }
  }
  return best;
}

// nullptr where the search finds none.
PathPtr path_of_car(const CarTask& task, const ob::SpaceInformationPtr& si, const StopTest& stop) {
  const auto poses = car_path(task, stop);
  if (!poses) return nullptr;
  const PathPtr path = as_states(*poses, si);
  return path->check() ? path : nullptr;
}

const DrivabilityChecker* checker_of(const ob::SpaceInformationPtr& si) {
  return dynamic_cast<const DrivabilityChecker*>(si->getStateValidityChecker().get());
}

const AlignabilityObjective* objective_of(const ob::ProblemDefinitionPtr& problem) {
  return dynamic_cast<const AlignabilityObjective*>(problem->getOptimizationObjective().get());
}

}  // namespace

FieldPlanner::FieldPlanner(const ob::SpaceInformationPtr& si) : ob::Planner(si, "Field") {
  specs_.optimizingPaths = true;
  specs_.canReportIntermediateSolutions = true;
  specs_.recognizedGoal = ob::GOAL_SAMPLEABLE_REGION;
}

void FieldPlanner::setup() {
  ob::Planner::setup();
  if (checker_of(si_) == nullptr) throw ompl::Exception(name_, "needs a DrivabilityChecker to check states");
  if (pdef_ && objective_of(pdef_) == nullptr) throw ompl::Exception(name_, "needs an AlignabilityObjective");
}

ob::PlannerStatus FieldPlanner::solve(const ob::PlannerTerminationCondition& until) {
  checkValidity();
  if (path_) return add_path();
  if (search_) return search_on(until);
  const ob::State* start = pis_.nextStart();
  if (start == nullptr) return ob::PlannerStatus::INVALID_START;
  const ob::State* goal = pis_.nextGoal(until);
  if (goal == nullptr) return ob::PlannerStatus::INVALID_GOAL;
  const auto* region = dynamic_cast<const PoseGoal*>(pdef_->getGoal().get());
  const AlignabilityObjective& objective = *objective_of(pdef_);
  const Task task{checker_of(si_)->area(),
                  objective,
                  objective.pose_of(start),
                  objective.pose_of(goal),
                  region == nullptr ? GoalTolerance{0.0, 0.0} : region->tolerance(),
                  !has_heading(*si_->getStateSpace())};
  const StopTest stop = [&until] { return until.eval(); };
  try {
    path_ = objective.steering() == nullptr ? best_path_of_disks(task, pdef_, stop)
                                            : path_of_car({task.area, objective, task.start, task.goal, task.tolerance}, si_, stop);
  } catch (const Interrupted&) {
    // The next call begins anew.
    pis_.restart();
    return ob::PlannerStatus::TIMEOUT;
  }
  return path_ ? add_path() : search_on(until);
}

ob::PlannerStatus FieldPlanner::add_path() const {
  const auto objective = pdef_->getOptimizationObjective();
  const ob::Cost cost = path_->cost(objective);
  if (const auto& report = pdef_->getIntermediateSolutionCallback()) {
    report(this, {path_->getStates().begin(), path_->getStates().end()}, cost);
  }
  ob::PlannerSolution solution(path_);
  solution.setPlannerName(getName());
  solution.setOptimized(objective, cost, objective->isSatisfied(cost));
  pdef_->addSolutionPath(solution);
  return ob::PlannerStatus::EXACT_SOLUTION;
}

ob::PlannerStatus FieldPlanner::search_on(const ob::PlannerTerminationCondition& until) {
  if (!search_) {
    search_ = make_planner({.name = "bitstar"}, si_);
    search_->setProblemDefinition(pdef_);
    search_->setup();
  }
  if (!search_iterations_) return search_->solve(until);
  std::int64_t asked = 0;
  return search_->solve(ob::PlannerTerminationCondition([&] { return until.eval() || asked++ >= *search_iterations_; }));
}

void FieldPlanner::clear() {
  ob::Planner::clear();
  path_.reset();
  search_.reset();
}

void FieldPlanner::getPlannerData(ob::PlannerData& data) const {
  ob::Planner::getPlannerData(data);
  if (search_) return search_->getPlannerData(data);
  if (!path_ || path_->getStateCount() == 0) return;
  const std::vector<ob::State*>& states = path_->getStates();
  for (std::size_t i = 1; i < states.size(); ++i) data.addEdge(ob::PlannerDataVertex(states[i - 1]), ob::PlannerDataVertex(states[i]));
  data.addStartVertex(ob::PlannerDataVertex(states.front()));
  data.addGoalVertex(ob::PlannerDataVertex(states.back()));
}

}  // namespace alignability
