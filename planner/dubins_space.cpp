// SPDX-License-Identifier: BSD-3-Clause
#include "planner/dubins_space.hpp"

#include <array>
#include <limits>
#include <numbers>

namespace alignability {
namespace {

namespace ob = ompl::base;

// A goal as seen from the start, in radii.
struct Goal {
  double x;
  double y;
  double yaw;
};

// Three pieces: left 1, right -1, straight 0, and how long each, in radii.
struct Word {
  std::array<int, 3> turns{};
  std::array<double, 3> lengths{};

  double length() const { return lengths[0] + lengths[1] + lengths[2]; }
};

constexpr double kRounding = 1e-9;  // [rad] or radii

// In [0, 2π); a turn that rounding alone keeps from being none is none.
double turn(double angle) {
  const double whole = 2.0 * std::numbers::pi;
  const double within = angle - whole * std::floor(angle / whole);
  return within > whole - kRounding ? 0.0 : within;
}

// The rest by mirroring these. Along the line between the centres of the first and the last circle.
void add_left_straight_left(const Goal& goal, int side, Word& best) {
  const double u = goal.x - std::sin(goal.yaw);
  const double v = goal.y - 1.0 + std::cos(goal.yaw);
  const double straight = std::hypot(u, v);
  // Of a single arc the straight is rounding alone, and points anywhere.
  const double along = straight > kRounding ? std::atan2(v, u) : 0.0;
  const Word word{{side, 0, side}, {turn(along), straight, turn(goal.yaw - along)}};
  if (word.length() < best.length()) best = word;
}

// Across it.
void add_left_straight_right(const Goal& goal, int side, Word& best) {
  const double u = goal.x + std::sin(goal.yaw);
  const double v = goal.y - 1.0 - std::cos(goal.yaw);
  const double squared = u * u + v * v - 4.0;
  if (squared < 0.0) return;
  const double straight = std::sqrt(squared);
  const double along = std::atan2(v, u) + std::atan2(2.0, straight);
  const Word word{{side, 0, -side}, {turn(along), straight, turn(along - goal.yaw)}};
  if (word.length() < best.length()) best = word;
}

// By a circle between that touches both, of the two there are the one that is turned on by more than π.
void add_left_right_left(const Goal& goal, int side, Word& best) {
  const double u = goal.x - std::sin(goal.yaw);
  const double v = goal.y - 1.0 + std::cos(goal.yaw);
  const double apart = std::hypot(u, v);
  if (apart > 4.0) return;
  const double aside = std::acos(0.25 * apart);
  const double to_middle = std::atan2(v, u) + aside;
  const double from_middle = std::atan2(v, u) - aside;
  const Word word{
      {side, -side, side},
      {turn(to_middle + 0.5 * std::numbers::pi), std::numbers::pi + 2.0 * aside, turn(goal.yaw - 1.5 * std::numbers::pi - from_middle)}};
  if (word.length() < best.length()) best = word;
}

Word shortest_word(const Goal& goal) {
  Word best{{0, 0, 0}, {std::numeric_limits<double>::infinity(), 0.0, 0.0}};
  const Goal mirrored{goal.x, -goal.y, -goal.yaw};
  for (const int side : {1, -1}) {
    const Goal& seen = side > 0 ? goal : mirrored;
    add_left_straight_left(seen, side, best);
    add_left_straight_right(seen, side, best);
    add_left_right_left(seen, side, best);
  }
  return best;
}

Pose2 pose_of(const ob::State* state) {
  const auto* pose = state->as<ob::SE2StateSpace::StateType>();
  return {pose->getX(), pose->getY(), pose->getYaw()};
}

}  // namespace

Curve shortest_dubins_curve(const Pose2& from, const Pose2& to, double radius) {
  const Eigen::Vector2d way = (to.position() - from.position()) / radius;
  const double c = std::cos(from.yaw);
  const double s = std::sin(from.yaw);
  const Word word = shortest_word({c * way.x() + s * way.y(), c * way.y() - s * way.x(), to.yaw - from.yaw});
  Curve curve(from);
  for (std::size_t i = 0; i < 3; ++i) curve.append(word.turns[i] / radius, word.lengths[i] * radius);
  return curve;
}

double DubinsSpace::distance(const ob::State* from, const ob::State* to) const {
  return shortest_dubins_curve(pose_of(from), pose_of(to), rho_).length();
}

void DubinsSpace::interpolate(const ob::State* from, const ob::State* to, double share, ob::State* state) const {
  if (share >= 1.0) {
    if (to != state) copyState(state, to);
    return;
  }
  const Curve curve = shortest_dubins_curve(pose_of(from), pose_of(to), rho_);
  const Pose2 at = curve.at(std::max(0.0, share) * curve.length());
  auto* pose = state->as<StateType>();
  pose->setXY(at.x, at.y);
  pose->setYaw(normalized_angle(at.yaw));
}

void DubinsSpace::interpolate(const ob::State* from, const ob::State* to, double share, bool& /*first_time*/, DubinsPath& /*path*/,
                              ob::State* state) const {
  interpolate(from, to, share, state);
}

}  // namespace alignability
