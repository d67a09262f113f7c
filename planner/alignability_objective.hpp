// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ompl/base/OptimizationObjective.h>

#include <memory>
#include <optional>

#include "costmap/risk_field.hpp"
#include "planner/route_bounds.hpp"
#include "planner/state_projection.hpp"
#include "planner/steering.hpp"

namespace alignability {

/// How `base_link` moves between two states that a planner joins.
enum class MotionShape {
  straight,      ///< straight in the plane, as in R² and SE(2): integrated in closed form
  curved,        ///< as a car, in Dubins and Reeds-Shepp spaces: along the true curves, in closed form
  interpolated,  ///< as the state space interpolates: integrated along chords as long as the space's valid segments
};

struct ObjectiveOptions {
  double weight = 5.0;           ///< w >= 0; 0 is the shortest path
  double turn_cost = 0.2;        ///< >= 0 [m/rad]
  double reverse_penalty = 1.0;  ///< >= 0; what a metre costs more when driven backward, of curved motions alone
};

/// Cost of a path in equivalent metres: J = ∫ (1 + w·risk) ds + turn_cost·∫ |dyaw| + reverse_penalty·(length driven backward). Heuristics
/// are its lower bounds: length and turning, or what set_bounds gives. Additive under splitting, finite everywhere, symmetric for straight
/// motions but in R² where risk depends on heading: there a robot faces where it goes. Const and without mutable state: one objective
/// serves many threads.
class AlignabilityObjective : public ompl::base::OptimizationObjective {
 public:
  /// In R², SE(2), Dubins and Reeds-Shepp spaces. Throws ompl::Exception in other spaces and for options out of range.
  AlignabilityObjective(const ompl::base::SpaceInformationPtr& si, std::shared_ptr<const RiskField> risk, const ObjectiveOptions& options);
  /// In any space, by a projection; `curved` in Dubins and Reeds-Shepp spaces alone.
  AlignabilityObjective(const ompl::base::SpaceInformationPtr& si, std::shared_ptr<const RiskField> risk, const ObjectiveOptions& options,
                        StateProjection projection, MotionShape shape);

  /// 1 + w·risk: what a metre costs there; in R², which has no headings, at the best.
  ompl::base::Cost stateCost(const ompl::base::State* state) const override;
  ompl::base::Cost motionCost(const ompl::base::State* from, const ompl::base::State* to) const override;
  /// The straight way's length or, with bounds, what they say of the two places, and turning: admissible, consistent, symmetric.
  ompl::base::Cost motionCostHeuristic(const ompl::base::State* from, const ompl::base::State* to) const override;
  bool isSymmetric() const override;
  /// In spaces with a projection of their own: with bounds an InformedFieldSampler, with a PoseGoal an EllipseSampler; else OMPL's, which
  /// draws from the whole space and rejects.
  ompl::base::InformedSamplerPtr allocInformedStateSampler(const ompl::base::ProblemDefinitionPtr& problem,
                                                           unsigned int largest_number_of_calls) const override;

  /// From now on informed samplers, heuristic and cost-to-go go by bounds for the start and goal of the problem and this objective's
  /// weight, so that planners search a cost map as narrowly as they search for a short path. Not while a planner runs.
  void set_bounds(std::shared_ptr<const RouteBounds> bounds);
  /// nullptr without.
  const std::shared_ptr<const RouteBounds>& bounds() const { return bounds_; }

  const ObjectiveOptions& options() const { return options_; }
  const RiskField& risk_field() const { return *risk_; }
  Pose2 pose_of(const ompl::base::State* state) const { return projection_(state); }
  /// J of a car's motion.
  double cost_of(const Curve& curve) const;
  double cost_of(const Arc& arc) const;
  /// What joins two poses; nullptr but for curved motions.
  const Steering* steering() const { return steering_ ? &*steering_ : nullptr; }

 private:
  double straight_cost(const Pose2& from, const Pose2& to) const;
  double turning(const Pose2& from, const Pose2& to) const;
  ompl::base::Cost least_to_go(const ompl::base::State* state, const ompl::base::Goal* goal) const;
  double least_turning(const ompl::base::ProblemDefinition& problem) const;
  double interpolated_cost(const ompl::base::State* from, const ompl::base::State* to) const;

  std::shared_ptr<const RiskField> risk_;
  std::shared_ptr<const RouteBounds> bounds_;
  ObjectiveOptions options_;
  StateProjection projection_;
  MotionShape shape_;
  std::optional<Steering> steering_;  // of curved motions
  bool in_plain_space_ = false;       // with a projection of its own
  bool faces_ahead_ = false;          // in R²
};

}  // namespace alignability
