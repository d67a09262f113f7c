// SPDX-License-Identifier: BSD-3-Clause
#include "planner/informed_field_sampler.hpp"

#include <ompl/base/ProblemDefinition.h>

#include <numbers>

#include "planner/poses.hpp"
#include "planner/state_projection.hpp"

namespace alignability {
namespace ob = ompl::base;

InformedFieldSampler::InformedFieldSampler(const ob::ProblemDefinitionPtr& problem, unsigned int largest_number_of_calls,
                                           std::shared_ptr<const RouteBounds> bounds, double turning)
    : ob::InformedSampler(problem, largest_number_of_calls),
      bounds_(std::move(bounds)),
      turning_(turning),
      everywhere_(space_->allocStateSampler()) {}

bool InformedFieldSampler::sampleUniform(ob::State* state, const ob::Cost& /*from*/, const ob::Cost& below) {
  return sampleUniform(state, below);
}

bool InformedFieldSampler::sampleUniform(ob::State* state, const ob::Cost& below) {
  const std::size_t cells = bounds_->cells_below(below.value() - turning_);
  if (cells == 0) return false;
  for (unsigned int i = 0; i < numIters_; ++i) {
    const Eigen::AlignedBox2d cell = bounds_->cell(static_cast<std::size_t>(random_.uniformInt(0, static_cast<int>(cells) - 1)));
    const Eigen::Vector2d at = cell.min() + cell.sizes().cwiseProduct(Eigen::Vector2d(random_.uniform01(), random_.uniform01()));
    if (!(bounds_->through(at) + turning_ < below.value())) continue;
    everywhere_->sampleUniform(state);
    set_pose(*space_, {at.x(), at.y(), projection_of(space_)(state).yaw}, state);
    if (space_->satisfiesBounds(state)) return true;
  }
  return false;
}

double InformedFieldSampler::getInformedMeasure(const ob::Cost& below) const {
  const std::size_t cells = bounds_->cells_below(below.value() - turning_);
  if (cells == 0) return 0.0;
  const double headings = has_heading(*space_) ? 2.0 * std::numbers::pi : 1.0;
  return static_cast<double>(cells) * bounds_->cell(0).volume() * headings;
}

}  // namespace alignability
