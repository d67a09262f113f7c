// SPDX-License-Identifier: BSD-3-Clause
#include "planner/steering.hpp"

#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/util/Exception.h>

#include <array>

#include "planner/dubins_space.hpp"

namespace alignability {
namespace {

namespace ob = ompl::base;

// A state of SE(2) without a space that allocates it.
class PoseState {
 public:
  explicit PoseState(const Pose2& pose) : place_{pose.x, pose.y} {
    position_.values = place_.data();
    heading_.value = pose.yaw;
    parts_ = {&position_, &heading_};
    state_.components = parts_.data();
  }
  PoseState(const PoseState&) = delete;
  PoseState& operator=(const PoseState&) = delete;

  const ob::State* get() const { return &state_; }

 private:
  std::array<double, 2> place_;
  ob::RealVectorStateSpace::StateType position_;
  ob::SO2StateSpace::StateType heading_;
  std::array<ob::State*, 2> parts_;
  ob::SE2StateSpace::StateType state_;
};

double left_or_right(ob::ReedsSheppStateSpace::ReedsSheppPathSegmentType type) {
  return type == ob::ReedsSheppStateSpace::RS_LEFT ? 1.0 : type == ob::ReedsSheppStateSpace::RS_RIGHT ? -1.0 : 0.0;
}

// OMPL keeps the radius to itself: a place as far ahead as many radii as the word to it is long.
template <typename Word>
double radius_of(Word word) {
  const PoseState here({0.0, 0.0, 0.0});
  const PoseState ahead({1.0, 0.0, 0.0});
  return 1.0 / word(here.get(), ahead.get()).length();
}

}  // namespace

bool Steering::serves(const ob::StateSpace& space) {
  return dynamic_cast<const ob::DubinsStateSpace*>(&space) != nullptr || dynamic_cast<const ob::ReedsSheppStateSpace*>(&space) != nullptr;
}

Steering::Steering(const ob::StateSpacePtr& space) : reeds_shepp_(std::dynamic_pointer_cast<const ob::ReedsSheppStateSpace>(space)) {
  const auto dubins = std::dynamic_pointer_cast<const ob::DubinsStateSpace>(space);
  if (dubins && dubins->hasSymmetricInterpolate()) throw ompl::Exception("Steering", "a Dubins space must not be symmetric");
  if (dubins) {
    radius_ = radius_of([&](const ob::State* from, const ob::State* to) { return dubins->dubins(from, to); });
  } else if (reeds_shepp_) {
    radius_ = radius_of([&](const ob::State* from, const ob::State* to) { return reeds_shepp_->reedsShepp(from, to); });
  } else {
    throw ompl::Exception("Steering", "the state space '" + space->getName() + "' is no Dubins or Reeds-Shepp space");
  }
}

Curve Steering::word(const Pose2& from, const Pose2& to) const {
  if (!reeds_shepp_) return shortest_dubins_curve(from, to, radius_);
  const auto word = reeds_shepp_->reedsShepp(PoseState(from).get(), PoseState(to).get());
  Curve curve(from);
  // Lengths of words are in radii.
  for (std::size_t i = 0; i < Curve::kMostArcs; ++i) curve.append(left_or_right(word.type_[i]) / radius_, word.length_[i] * radius_);
  return curve;
}

std::optional<Curve> Steering::operator()(const Pose2& from, const Pose2& to) const {
  constexpr double kNear = 1e-6;  // [m], [rad]
  const Curve curve = word(from, to);
  const Pose2 end = curve.end();
  if (!((end.position() - to.position()).norm() <= kNear && std::abs(normalized_angle(end.yaw - to.yaw)) <= kNear)) return std::nullopt;
  return curve;
}

}  // namespace alignability
