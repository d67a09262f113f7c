// SPDX-License-Identifier: BSD-3-Clause
#include "planner/drivability.hpp"

#include <ompl/base/SpaceInformation.h>

namespace alignability {
namespace ob = ompl::base;

DrivabilityChecker::DrivabilityChecker(const ob::SpaceInformationPtr& si, DrivableArea area)
    : DrivabilityChecker(si, std::move(area), projection_of(si->getStateSpace())) {}

DrivabilityChecker::DrivabilityChecker(const ob::SpaceInformationPtr& si, DrivableArea area, StateProjection projection)
    : ob::StateValidityChecker(si), area_(std::move(area)), projection_(std::move(projection)) {
  specs_.clearanceComputationType = ob::StateValidityCheckerSpecs::EXACT;
}

bool DrivabilityChecker::isValid(const ob::State* state) const { return si_->satisfiesBounds(state) && area_.contains(projection_(state)); }

double DrivabilityChecker::clearance(const ob::State* state) const { return area_.clearance(projection_(state)); }

DrivabilityMotionValidator::DrivabilityMotionValidator(const ob::SpaceInformationPtr& si, DrivableArea area)
    : ob::MotionValidator(si), area_(std::move(area)), projection_(projection_of(si->getStateSpace())) {}

bool DrivabilityMotionValidator::checkMotion(const ob::State* from, const ob::State* to) const {
  return si_->satisfiesBounds(to) && area_.contains(projection_(from), projection_(to));
}

bool DrivabilityMotionValidator::checkMotion(const ob::State* from, const ob::State* to, std::pair<ob::State*, double>& last_valid) const {
  if (checkMotion(from, to)) return true;
  const Pose2 a = projection_(from);
  const Pose2 b = projection_(to);
  const auto clear_until = [&](double share) { return area_.contains(a, between(a, b, share)); };
  double valid = 0.0;
  double invalid = 1.0;
  while (invalid - valid > 1e-9) {
    const double middle = 0.5 * (valid + invalid);
    (clear_until(middle) ? valid : invalid) = middle;
  }
  last_valid.second = valid;
  if (last_valid.first != nullptr) si_->getStateSpace()->interpolate(from, to, valid, last_valid.first);
  return false;
}

}  // namespace alignability
