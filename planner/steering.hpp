// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ompl/base/StateSpace.h>

#include <memory>
#include <optional>

#include "planner/curve.hpp"

namespace ompl::base {
class ReedsSheppStateSpace;
}  // namespace ompl::base

namespace alignability {

/// How a car gets from one pose to another in one of OMPL's Dubins or Reeds-Shepp spaces: the shortest curve, which OMPL's interpolation
/// follows too. Of Reeds and Shepp's by OMPL's words; of Dubins's see shortest_dubins_curve. Safe to use from many threads, allocates
/// nothing.
class Steering {
 public:
  /// Whether a space is one of those.
  static bool serves(const ompl::base::StateSpace& space);

  /// Throws ompl::Exception for other spaces, and for Dubins spaces made symmetric, in which a motion may be another's, driven backward.
  explicit Steering(const ompl::base::StateSpacePtr& space);

  /// nullopt where rounding left no curve that ends there, to a millionth of a metre and of a radian.
  std::optional<Curve> operator()(const Pose2& from, const Pose2& to) const;
  /// Wherever it ends.
  Curve word(const Pose2& from, const Pose2& to) const;

  double turning_radius() const { return radius_; }  ///< [m]
  bool may_reverse() const { return reeds_shepp_ != nullptr; }

 private:
  std::shared_ptr<const ompl::base::ReedsSheppStateSpace> reeds_shepp_;  // nullptr in a Dubins space
  double radius_ = 1.0;
};

}  // namespace alignability
