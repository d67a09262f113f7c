// SPDX-License-Identifier: BSD-3-Clause
#include "planner/ellipse_sampler.hpp"

namespace alignability {
namespace ob = ompl::base;

EllipseSampler::EllipseSampler(const ob::ProblemDefinitionPtr& problem, unsigned int largest_number_of_calls, const PoseGoal& goal)
    : ob::PathLengthDirectInfSampler(problem, largest_number_of_calls), tolerance_(goal.tolerance().position) {}

bool EllipseSampler::sampleUniform(ob::State* state, const ob::Cost& below) {
  return ob::PathLengthDirectInfSampler::sampleUniform(state, widened(below));
}

// Down to `from` would leave out places that only the tolerance brings near.
bool EllipseSampler::sampleUniform(ob::State* state, const ob::Cost& /*from*/, const ob::Cost& below) {
  return sampleUniform(state, below);
}

double EllipseSampler::getInformedMeasure(const ob::Cost& below) const {
  return ob::PathLengthDirectInfSampler::getInformedMeasure(widened(below));
}

}  // namespace alignability
