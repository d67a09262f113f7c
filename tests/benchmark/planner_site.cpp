// SPDX-License-Identifier: BSD-3-Clause
#include "tests/benchmark/planner_site.hpp"

#include <ompl/base/objectives/StateCostIntegralObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>

#include <limits>

#include "planner/dubins_space.hpp"
#include "planner/pose_goal.hpp"
#include "planner/poses.hpp"

namespace alignability::benchmark {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

// A user's own objective on OMPL's stock integral: trapezoids by steps of the space's valid segments. In SE(2) the space's distance would
// charge for turning what our objective does not, so turning is charged apart.
class StockObjective : public ob::StateCostIntegralObjective {
 public:
  StockObjective(const ob::SpaceInformationPtr& si, std::shared_ptr<const RiskField> risk, const ObjectiveOptions& options)
      : ob::StateCostIntegralObjective(si, true),
        risk_(std::move(risk)),
        options_(options),
        pose_of_(projection_of(si->getStateSpace())),
        may_reverse_(dynamic_cast<const ob::ReedsSheppStateSpace*>(si->getStateSpace().get()) != nullptr) {}

  // Of curves the way back costs something else.
  bool isSymmetric() const override { return !Steering::serves(*si_->getStateSpace()); }

  ob::Cost stateCost(const ob::State* state) const override {
    const Pose2 at = pose_of_(state);
    return ob::Cost(1.0 + options_.weight * risk_->risk(at.x, at.y, at.yaw));
  }

  ob::Cost motionCost(const ob::State* from, const ob::State* to) const override {
    if (!has_heading(*si_->getStateSpace())) return ob::StateCostIntegralObjective::motionCost(from, to);
    const ob::StateSpacePtr& space = si_->getStateSpace();
    const unsigned int steps = std::max(1u, space->validSegmentCount(from, to));
    ob::State* at = si_->allocState();
    Pose2 before = pose_of_(from);
    double cost_before = stateCost(from).value();
    double cost = 0.0;
    for (unsigned int i = 1; i <= steps; ++i) {
      space->interpolate(from, to, static_cast<double>(i) / steps, at);
      const Pose2 here = pose_of_(at);
      const double cost_here = stateCost(at).value();
      const Eigen::Vector2d step = here.position() - before.position();
      cost += 0.5 * (cost_before + cost_here) * step.norm();
      cost += options_.turn_cost * std::abs(normalized_angle(here.yaw - before.yaw));
      if (may_reverse_ && step.dot(Eigen::Vector2d(std::cos(here.yaw), std::sin(here.yaw))) < 0.0) {
        cost += options_.reverse_penalty * step.norm();
      }
      before = here;
      cost_before = cost_here;
    }
    si_->freeState(at);
    return ob::Cost(cost);
  }

 private:
  std::shared_ptr<const RiskField> risk_;
  ObjectiveOptions options_;
  StateProjection pose_of_;
  bool may_reverse_;
};

ob::StateSpacePtr make_space(const Motion& motion) {
  switch (motion.space) {
    case MotionSpace::r2:
      return std::make_shared<ob::RealVectorStateSpace>(2);
    case MotionSpace::se2:
      return std::make_shared<ob::SE2StateSpace>();
    case MotionSpace::dubins:
      // For all: OMPL's own ends the program now and then.
      return std::make_shared<DubinsSpace>(motion.turning_radius);
    case MotionSpace::reeds_shepp:
      return std::make_shared<ob::ReedsSheppStateSpace>(motion.turning_radius);
  }
  return nullptr;
}

ob::StateSpacePtr space_over(const GridGeometry& map, const Motion& motion) {
  ob::RealVectorBounds bounds(2);
  for (const unsigned int axis : {0u, 1u}) {
    bounds.setLow(axis, map.origin[axis]);
    bounds.setHigh(axis, map.upper_corner()[axis]);
  }
  const ob::StateSpacePtr space = make_space(motion);
  if (motion.space == MotionSpace::r2) {
    space->as<ob::RealVectorStateSpace>()->setBounds(bounds);
  } else {
    space->as<ob::SE2StateSpace>()->setBounds(bounds);
  }
  return space;
}

ObjectiveOptions options_of(const PlanQuery& query) {
  return {.weight = query.weight, .turn_cost = query.motion.turn_cost, .reverse_penalty = query.motion.reverse_penalty};
}

}  // namespace

Site::Site(std::string its_name, PlanProblem its_problem, const Motion& motion)
    : name(std::move(its_name)),
      problem(std::move(its_problem)),
      fields(problem),
      area(fields.clearance, fields.risk, problem.query.robot),
      judge_(std::make_shared<ob::SpaceInformation>(space_over(area.geometry(), motion))) {
  problem.query.motion = motion;
  judge_->setStateValidityChecker(std::make_shared<DrivabilityChecker>(judge_, area));
  judge_->setMotionValidator(motion_validator_for(judge_, area));
  judge_->setup();
  cost_ = std::make_unique<const AlignabilityObjective>(judge_, fields.risk, options_of(problem.query));
}

og::SimpleSetup Site::setup(Parts parts) const {
  const PlanQuery& query = problem.query;
  const ob::StateSpacePtr space = space_over(area.geometry(), query.motion);
  og::SimpleSetup made(space);
  const ob::SpaceInformationPtr& si = made.getSpaceInformation();
  made.setStateValidityChecker(std::make_shared<DrivabilityChecker>(si, area));
  if (parts == Parts::stock) {
    made.setOptimizationObjective(std::make_shared<StockObjective>(si, fields.risk, options_of(query)));
    // By default a step would be a hundredth of the map, and most paths would collide.
    si->setStateValidityCheckingResolution(area.geometry().resolution / space->getMaximumExtent());
  } else {
    si->setMotionValidator(motion_validator_for(si, area));
    const auto objective = std::make_shared<AlignabilityObjective>(si, fields.risk, options_of(query));
    if (parts == Parts::ours_with_bounds) objective->set_bounds(bounds());
    made.setOptimizationObjective(objective);
  }
  ob::ScopedState<> start(space);
  set_pose(*space, query.start, start.get());
  made.setStartState(start);
  made.setGoal(std::make_shared<PoseGoal>(si, query.goal, query.goal_tolerance));
  return made;
}

std::shared_ptr<const RouteBounds> Site::bounds() const {
  const PlanQuery& query = problem.query;
  return std::make_shared<const RouteBounds>(area, query.weight, query.start.position(), query.goal.position(),
                                             query.goal_tolerance.position);
}

double Site::lower_bound() const {
  const PlanQuery& query = problem.query;
  const double along = bounds()->to_goal(query.start.position());
  if (query.motion.space == MotionSpace::r2) return along;
  const double turn = std::abs(normalized_angle(query.goal.yaw - query.start.yaw)) - query.goal_tolerance.heading;
  return along + query.motion.turn_cost * std::max(0.0, turn);
}

double Site::true_cost(const og::PathGeometric& path) const {
  double cost = 0.0;
  for (unsigned int i = 1; i < path.getStateCount(); ++i) {
    if (!judge_->checkMotion(path.getState(i - 1), path.getState(i))) return std::numeric_limits<double>::infinity();
    cost += cost_->motionCost(path.getState(i - 1), path.getState(i)).value();
  }
  return cost;
}

}  // namespace alignability::benchmark
