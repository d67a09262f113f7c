// SPDX-License-Identifier: BSD-3-Clause
#include "planner/drivability.hpp"

#include <ompl/base/SpaceInformation.h>

#include "planner/headings.hpp"
#include "planner/poses.hpp"

namespace alignability {
namespace ob = ompl::base;

namespace {

// The share of a motion, to a billionth, up to which it is valid.
template <typename IsValidUntil>
double greatest_valid(IsValidUntil is_valid_until) {
  double valid = 0.0;
  double invalid = 1.0;
  while (invalid - valid > 1e-9) {
    const double middle = 0.5 * (valid + invalid);
    (is_valid_until(middle) ? valid : invalid) = middle;
  }
  return valid;
}

}  // namespace

DrivabilityChecker::DrivabilityChecker(const ob::SpaceInformationPtr& si, DrivableArea area)
    : DrivabilityChecker(si, std::move(area), projection_of(si->getStateSpace())) {
  has_heading_ = has_heading(*si->getStateSpace());
}

DrivabilityChecker::DrivabilityChecker(const ob::SpaceInformationPtr& si, DrivableArea area, StateProjection projection)
    : ob::StateValidityChecker(si), area_(std::move(area)), projection_(std::move(projection)) {
  specs_.clearanceComputationType = ob::StateValidityCheckerSpecs::EXACT;
}

bool DrivabilityChecker::isValid(const ob::State* state) const {
  if (!si_->satisfiesBounds(state)) return false;
  const Pose2 pose = projection_(state);
  return has_heading_ ? area_.contains(pose) : area_.contains_disk(pose.position());
}

double DrivabilityChecker::clearance(const ob::State* state) const { return area_.clearance(projection_(state)); }

DrivabilityMotionValidator::DrivabilityMotionValidator(const ob::SpaceInformationPtr& si, DrivableArea area)
    : ob::MotionValidator(si),
      area_(std::move(area)),
      projection_(projection_of(si->getStateSpace())),
      has_heading_(has_heading(*si->getStateSpace())) {}

bool DrivabilityMotionValidator::is_drivable(const Pose2& from, const Pose2& to) const {
  if (has_heading_) return area_.contains(from, to);
  if (from.position() == to.position()) return area_.contains_disk(to.position());
  const auto [begin, end] = facing_ahead(from.position(), to.position());
  return area_.contains(begin, end);
}

bool DrivabilityMotionValidator::checkMotion(const ob::State* from, const ob::State* to) const {
  return si_->satisfiesBounds(to) && is_drivable(projection_(from), projection_(to));
}

bool DrivabilityMotionValidator::checkMotion(const ob::State* from, const ob::State* to, std::pair<ob::State*, double>& last_valid) const {
  if (checkMotion(from, to)) return true;
  const Pose2 a = projection_(from);
  const Pose2 b = projection_(to);
  last_valid.second = greatest_valid([&](double share) { return is_drivable(a, between(a, b, share)); });
  if (last_valid.first != nullptr) si_->getStateSpace()->interpolate(from, to, last_valid.second, last_valid.first);
  return false;
}

CurveMotionValidator::CurveMotionValidator(const ob::SpaceInformationPtr& si, DrivableArea area)
    : ob::MotionValidator(si), area_(std::move(area)), projection_(projection_of(si->getStateSpace())), steering_(si->getStateSpace()) {}

bool CurveMotionValidator::checkMotion(const ob::State* from, const ob::State* to) const {
  if (!si_->satisfiesBounds(to)) return false;
  const auto curve = steering_(projection_(from), projection_(to));
  return curve && area_.contains(*curve);
}

bool CurveMotionValidator::checkMotion(const ob::State* from, const ob::State* to, std::pair<ob::State*, double>& last_valid) const {
  if (checkMotion(from, to)) return true;
  const Curve curve = steering_.word(projection_(from), projection_(to));
  last_valid.second = greatest_valid([&](double share) { return area_.contains(curve.until(share * curve.length())); });
  if (last_valid.first != nullptr) si_->getStateSpace()->interpolate(from, to, last_valid.second, last_valid.first);
  return false;
}

ob::MotionValidatorPtr motion_validator_for(const ob::SpaceInformationPtr& si, const DrivableArea& area) {
  if (Steering::serves(*si->getStateSpace())) return std::make_shared<CurveMotionValidator>(si, area);
  return std::make_shared<DrivabilityMotionValidator>(si, area);
}

}  // namespace alignability
