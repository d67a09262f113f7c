// SPDX-License-Identifier: BSD-3-Clause
#include "planner/alignability_objective.hpp"

#include <ompl/base/SpaceInformation.h>
#include <ompl/util/Exception.h>

#include "core/range.hpp"
#include "planner/ellipse_sampler.hpp"
#include "planner/headings.hpp"
#include "planner/informed_field_sampler.hpp"
#include "planner/pose_goal.hpp"
#include "planner/poses.hpp"

namespace alignability {
namespace ob = ompl::base;

AlignabilityObjective::AlignabilityObjective(const ob::SpaceInformationPtr& si, std::shared_ptr<const RiskField> risk,
                                             const ObjectiveOptions& options)
    : AlignabilityObjective(si, std::move(risk), options, projection_of(si->getStateSpace()),
                            Steering::serves(*si->getStateSpace()) ? MotionShape::curved : MotionShape::straight) {
  in_plain_space_ = true;
  faces_ahead_ = risk_->has_headings() && !has_heading(*si->getStateSpace());
}

AlignabilityObjective::AlignabilityObjective(const ob::SpaceInformationPtr& si, std::shared_ptr<const RiskField> risk,
                                             const ObjectiveOptions& options, StateProjection projection, MotionShape shape)
    : ob::OptimizationObjective(si), risk_(std::move(risk)), options_(options), projection_(std::move(projection)), shape_(shape) {
  for (const double cost : {options.weight, options.turn_cost, options.reverse_penalty}) {
    if (!kCostWeights.contains(cost)) {
      throw ompl::Exception("AlignabilityObjective", "weight, turn_cost and reverse_penalty must be " + kCostWeights.description());
    }
  }
  if (shape == MotionShape::curved) steering_.emplace(si->getStateSpace());
  description_ = "Alignability";
  setCostToGoHeuristic([this](const ob::State* state, const ob::Goal* goal) { return least_to_go(state, goal); });
}

void AlignabilityObjective::set_bounds(std::shared_ptr<const RouteBounds> bounds) { bounds_ = std::move(bounds); }

ob::Cost AlignabilityObjective::stateCost(const ob::State* state) const {
  const Pose2 pose = projection_(state);
  const double risk = faces_ahead_ ? risk_->least_risk(pose.position()) : risk_->risk(pose.x, pose.y, pose.yaw);
  return ob::Cost(1.0 + options_.weight * risk);
}

ob::Cost AlignabilityObjective::motionCost(const ob::State* from, const ob::State* to) const {
  switch (shape_) {
    case MotionShape::straight:
      return ob::Cost(straight_cost(projection_(from), projection_(to)));
    case MotionShape::curved:
      return ob::Cost(cost_of(steering_->word(projection_(from), projection_(to))));
    case MotionShape::interpolated:
      return ob::Cost(interpolated_cost(from, to));
  }
  return infiniteCost();
}

ob::Cost AlignabilityObjective::motionCostHeuristic(const ob::State* from, const ob::State* to) const {
  const Pose2 a = projection_(from);
  const Pose2 b = projection_(to);
  const double straight = (b.position() - a.position()).norm();
  return ob::Cost((bounds_ ? std::max(straight, bounds_->between(a.position(), b.position())) : straight) + turning(a, b));
}

// The way back along a curve may be another: of two words as short, OMPL takes the first that it comes upon.
bool AlignabilityObjective::isSymmetric() const {
  return (shape_ == MotionShape::straight && !faces_ahead_) ||
         (shape_ == MotionShape::interpolated && si_->getStateSpace()->hasSymmetricInterpolate());
}

double AlignabilityObjective::cost_of(const Curve& curve) const {
  double cost = 0.0;
  for (const Arc& arc : curve.arcs()) cost += cost_of(arc);
  return cost;
}

double AlignabilityObjective::cost_of(const Arc& arc) const {
  const double backward = std::max(0.0, -arc.travel);
  return arc.length() + options_.weight * risk_->integral(arc) + options_.turn_cost * std::abs(arc.turn()) +
         options_.reverse_penalty * backward;
}

ob::InformedSamplerPtr AlignabilityObjective::allocInformedStateSampler(const ob::ProblemDefinitionPtr& problem,
                                                                        unsigned int largest_number_of_calls) const {
  const auto* goal = dynamic_cast<const PoseGoal*>(problem->getGoal().get());
  if (bounds_ && in_plain_space_) {
    return std::make_shared<InformedFieldSampler>(problem, largest_number_of_calls, bounds_, least_turning(*problem));
  }
  if (goal == nullptr || !in_plain_space_ || problem->getStartStateCount() != 1) {
    return ob::OptimizationObjective::allocInformedStateSampler(problem, largest_number_of_calls);
  }
  return std::make_shared<EllipseSampler>(problem, largest_number_of_calls, *goal);
}

double AlignabilityObjective::turning(const Pose2& from, const Pose2& to) const {
  if (from.yaw == to.yaw) return 0.0;
  return options_.turn_cost * std::abs(normalized_angle(to.yaw - from.yaw));
}

// A goal of another kind may be met anywhere, for all that is known of it.
ob::Cost AlignabilityObjective::least_to_go(const ob::State* state, const ob::Goal* goal) const {
  const auto* region = dynamic_cast<const PoseGoal*>(goal);
  if (region == nullptr) return ob::Cost(0.0);
  const Eigen::Vector2d at = projection_(state).position();
  const double straight = std::max(0.0, (at - region->pose().position()).norm() - region->tolerance().position);
  return ob::Cost(bounds_ ? std::max(straight, bounds_->to_goal(at)) : straight);
}

double AlignabilityObjective::least_turning(const ob::ProblemDefinition& problem) const {
  const auto* goal = dynamic_cast<const PoseGoal*>(problem.getGoal().get());
  if (goal == nullptr || problem.getStartStateCount() != 1 || !has_heading(*si_->getStateSpace())) return 0.0;
  const double turn = std::abs(normalized_angle(goal->pose().yaw - projection_(problem.getStartState(0)).yaw));
  return options_.turn_cost * std::max(0.0, turn - goal->tolerance().heading);
}

double AlignabilityObjective::straight_cost(const Pose2& from, const Pose2& to) const {
  const double length = (to.position() - from.position()).norm();
  if (faces_ahead_ && length > 0.0) {
    const auto [begin, end] = facing_ahead(from.position(), to.position());
    return length + options_.weight * risk_->integral(begin, end);
  }
  return length + options_.weight * risk_->integral(from, to) + turning(from, to);
}

double AlignabilityObjective::interpolated_cost(const ob::State* from, const ob::State* to) const {
  const ob::StateSpacePtr& space = si_->getStateSpace();
  const unsigned int chords = std::max(1u, space->validSegmentCount(from, to));
  ob::ScopedState<> at(space);
  double cost = 0.0;
  Pose2 begin = projection_(from);
  for (unsigned int i = 1; i <= chords; ++i) {
    space->interpolate(from, to, static_cast<double>(i) / chords, at.get());
    const Pose2 end = projection_(at.get());
    cost += straight_cost(begin, end);
    begin = end;
  }
  return cost;
}

}  // namespace alignability
