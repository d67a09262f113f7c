// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ompl/base/samplers/informed/PathLengthDirectInfSampler.h>

#include "planner/pose_goal.hpp"

namespace alignability {

/// Draws states straight from the ellipse of places that a path of at most a given cost can touch, which costs the same however small the
/// ellipse has become; drawing from the whole space and rejecting does not. Length is a lower bound of the cost, so nothing better is left
/// out: the foci are the start and the goal's pose, and the goal's tolerance widens the ellipse.
class EllipseSampler : public ompl::base::PathLengthDirectInfSampler {
 public:
  /// In R² or SE(2), with one start and a PoseGoal.
  EllipseSampler(const ompl::base::ProblemDefinitionPtr& problem, unsigned int largest_number_of_calls, const PoseGoal& goal);

  bool sampleUniform(ompl::base::State* state, const ompl::base::Cost& below) override;
  bool sampleUniform(ompl::base::State* state, const ompl::base::Cost& from, const ompl::base::Cost& below) override;
  double getInformedMeasure(const ompl::base::Cost& below) const override;

 private:
  // A little more than the tolerance, so that the ellipse never shrinks to nothing, which OMPL's does not survive.
  ompl::base::Cost widened(const ompl::base::Cost& cost) const { return ompl::base::Cost(cost.value() + 1.01 * tolerance_); }

  double tolerance_;  // of the goal [m]
};

}  // namespace alignability
