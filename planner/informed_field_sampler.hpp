// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ompl/base/samplers/InformedStateSampler.h>
#include <ompl/util/RandomNumbers.h>

#include "planner/route_bounds.hpp"

namespace alignability {

/// Draws states evenly from where a path through them may still cost less than a given cost, by certified bounds: cells that may hold such
/// places, then places within, and of these only those that are. Never from where the robot cannot be or get to. Headings are drawn evenly.
class InformedFieldSampler : public ompl::base::InformedSampler {
 public:
  /// In R² or SE(2). `turning` is what a path's turning costs at least, on top of the bounds.
  InformedFieldSampler(const ompl::base::ProblemDefinitionPtr& problem, unsigned int largest_number_of_calls,
                       std::shared_ptr<const RouteBounds> bounds, double turning);

  bool sampleUniform(ompl::base::State* state, const ompl::base::Cost& below) override;
  /// The same, down to `from` or not: bounds are no metric, and a path's places may have lower ones than its start. BIT* asks from its
  /// heuristic's cost of the whole way on; leaving out what is below kept it from the best places.
  bool sampleUniform(ompl::base::State* state, const ompl::base::Cost& from, const ompl::base::Cost& below) override;
  bool hasInformedMeasure() const override { return true; }
  /// Of the cells that may hold such places.
  double getInformedMeasure(const ompl::base::Cost& below) const override;

 private:
  std::shared_ptr<const RouteBounds> bounds_;
  double turning_;
  ompl::base::StateSamplerPtr everywhere_;
  ompl::RNG random_;
};

}  // namespace alignability
