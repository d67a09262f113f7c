// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ompl/base/MotionValidator.h>
#include <ompl/base/StateValidityChecker.h>

#include "planner/drivable_area.hpp"
#include "planner/state_projection.hpp"
#include "planner/steering.hpp"

namespace alignability {

/// A state is valid within the bounds of its space and where the drivable area contains its pose, in R² some pose there. Const, without
/// mutable state.
class DrivabilityChecker : public ompl::base::StateValidityChecker {
 public:
  /// In R², SE(2), Dubins and Reeds-Shepp spaces.
  DrivabilityChecker(const ompl::base::SpaceInformationPtr& si, DrivableArea area);
  DrivabilityChecker(const ompl::base::SpaceInformationPtr& si, DrivableArea area, StateProjection projection);

  bool isValid(const ompl::base::State* state) const override;
  /// [m], negative in collision.
  double clearance(const ompl::base::State* state) const override;

  const DrivableArea& area() const { return area_; }

 private:
  DrivableArea area_;
  StateProjection projection_;
  bool has_heading_ = true;
};

/// Checks straight motions (R², where a robot faces where it goes, and SE(2)) exactly. Counts nothing: OMPL's counters are not safe to
/// share between threads.
class DrivabilityMotionValidator : public ompl::base::MotionValidator {
 public:
  DrivabilityMotionValidator(const ompl::base::SpaceInformationPtr& si, DrivableArea area);

  bool checkMotion(const ompl::base::State* from, const ompl::base::State* to) const override;
  /// `last_valid` is found to a billionth of the motion.
  bool checkMotion(const ompl::base::State* from, const ompl::base::State* to,
                   std::pair<ompl::base::State*, double>& last_valid) const override;

 private:
  bool is_drivable(const Pose2& from, const Pose2& to) const;

  DrivableArea area_;
  StateProjection projection_;
  bool has_heading_;
};

/// Checks a car's motions along their true curves, in Dubins and Reeds-Shepp spaces; counts nothing. A motion for which OMPL has no curve
/// that ends where it should is not valid.
class CurveMotionValidator : public ompl::base::MotionValidator {
 public:
  CurveMotionValidator(const ompl::base::SpaceInformationPtr& si, DrivableArea area);

  bool checkMotion(const ompl::base::State* from, const ompl::base::State* to) const override;
  /// `last_valid` is found to a billionth of the motion.
  bool checkMotion(const ompl::base::State* from, const ompl::base::State* to,
                   std::pair<ompl::base::State*, double>& last_valid) const override;

 private:
  DrivableArea area_;
  StateProjection projection_;
  Steering steering_;
};

/// The validator that fits the space: one of these two.
ompl::base::MotionValidatorPtr motion_validator_for(const ompl::base::SpaceInformationPtr& si, const DrivableArea& area);

}  // namespace alignability
