// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ompl/base/spaces/DubinsStateSpace.h>

#include "planner/curve.hpp"

namespace alignability {

/// The shortest curve forward from one pose to another by arcs of a radius [m] and straights: the best of the six words of Shkel and
/// Lumelsky (Classification of the Dubins set, 2001). OMPL's `dubins` finds the same, but rounds angles to half a millionth and then ends
/// the program, by an assertion, where a long straight follows; this one ends within 1e-8 of the curve's length of its goal.
Curve shortest_dubins_curve(const Pose2& from, const Pose2& to, double radius);

/// OMPL's Dubins space with distances and interpolation by shortest_dubins_curve, and so safe to search for as long as one likes.
class DubinsSpace : public ompl::base::DubinsStateSpace {
 public:
  explicit DubinsSpace(double turning_radius) : ompl::base::DubinsStateSpace(turning_radius) {}

  double distance(const ompl::base::State* from, const ompl::base::State* to) const override;
  void interpolate(const ompl::base::State* from, const ompl::base::State* to, double share, ompl::base::State* state) const override;
  /// The same: what OMPL's own motion validator asks for.
  void interpolate(const ompl::base::State* from, const ompl::base::State* to, double share, bool& first_time, DubinsPath& path,
                   ompl::base::State* state) const override;
  using ompl::base::DubinsStateSpace::interpolate;
};

}  // namespace alignability
