// SPDX-License-Identifier: BSD-3-Clause
#include "planner/car_refinement.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace alignability {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kWorthIt = 1e-9;  // of the cost

using Poses = std::vector<Pose2>;

// The same way with poses added, so that none is further along the curve from the next than `spacing` [m].
Poses subdivided(const Poses& path, double spacing, const Steering& steering) {
  Poses finer{path.front()};
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Curve curve = steering.word(path[i - 1], path[i]);
    const int pieces = std::max(1, static_cast<int>(std::ceil(curve.length() / spacing)));
    for (int piece = 1; piece < pieces; ++piece) {
      Pose2 at = curve.at(curve.length() * piece / pieces);
      at.yaw = normalized_angle(at.yaw);
      finer.push_back(at);
    }
    finer.push_back(path[i]);
  }
  return finer;
}

// A way along some of the poses up to one of them.
struct Label {
  double cost;
  PathLimits::State state;
  std::size_t pose_before;
  std::size_t label_before;  // of that pose
};

// Keeps those that no other makes superfluous, the cheapest first.
void add(std::vector<Label>& labels, const Label& label, const PathLimits& limits) {
  const auto is_better = [&](const Label& one, const Label& other, double alike) {
    return one.cost <= other.cost && limits.is_no_worse(one.state, other.state, alike);
  };
  if (std::ranges::any_of(labels, [&](const Label& known) { return is_better(known, label, kAlikeToCars); })) return;
  std::erase_if(labels, [&](const Label& known) { return is_better(label, known, 0.0); });
  labels.insert(std::ranges::upper_bound(labels, label.cost, {}, &Label::cost), label);
}

// The cheapest of the paths that leave out poses, none further apart than the window, and keep the limits.
std::optional<Poses> with_shortcuts(const Poses& path, const CarTask& task) {
  constexpr std::size_t kWindow = 32;
  std::vector<std::vector<Label>> labels(path.size());
  labels[0] = {{0.0, task.limits.at_start(), 0, 0}};
  for (std::size_t to = 1; to < path.size(); ++to) {
    // The longest first: as a rule it is the cheapest, and without limits the shorter ones need no check then.
    for (std::size_t from = to > kWindow ? to - kWindow : 0; from < to; ++from) {
      if (labels[from].empty()) continue;
      const bool is_bounded = task.limits.empty() && !labels[to].empty();
      const double bound = is_bounded ? (1.0 - kWorthIt) * labels[to].front().cost - labels[from].front().cost : kInfinite;
      const auto leg = leg_below(bound, task, path[from], path[to]);
      if (!leg) continue;
      for (std::size_t i = 0; i < labels[from].size(); ++i) {
        const auto state = task.limits.after(labels[from][i].state, leg->curve, *task.area.risk_field());
        if (state) add(labels[to], {labels[from][i].cost + leg->cost, *state, from, i}, task.limits);
      }
    }
  }
  if (labels.back().empty()) return std::nullopt;
  Poses shorter;
  const Label* label = &labels.back().front();
  for (std::size_t at = path.size() - 1; at > 0;) {
    shorter.push_back(path[at]);
    at = label->pose_before;
    label = &labels[at][label->label_before];
  }
  shorter.push_back(path.front());
  return Poses{shorter.rbegin(), shorter.rend()};
}

bool keeps_limits(const Poses& path, const CarTask& task) {
  if (task.limits.empty()) return true;
  std::optional<PathLimits::State> state = task.limits.at_start();
  for (std::size_t i = 1; state && i < path.size(); ++i) {
    state = task.limits.after(*state, task.objective.steering()->word(path[i - 1], path[i]), *task.area.risk_field());
  }
  return state.has_value();
}

class Relaxation {
 public:
  Relaxation(Poses path, const CarTask& task) : path_(std::move(path)), task_(task), costs_(path_.size(), 0.0) {
    const Steering& steering = *task.objective.steering();
    for (std::size_t i = 1; i < path_.size(); ++i) costs_[i] = task.objective.cost_of(steering.word(path_[i - 1], path_[i]));
  }

  // Each pose but the first moved by steps, from `step` [m] down to a thousandth of it.
  Poses run(double step, const StopTest& stop) {
    constexpr int kSweeps = 60;
    std::vector<double> steps(path_.size(), step);
    bool going_on = true;
    for (int sweep = 0; sweep < kSweeps && going_on; ++sweep) {
      going_on = false;
      for (std::size_t i = 1; i < path_.size(); ++i) {
        if (steps[i] < 1e-3 * step) continue;
        if (is_told_to_stop(stop)) return path_;
        going_on = true;
        steps[i] *= move(i, steps[i]) ? 1.5 : 0.5;
      }
    }
    return path_;
  }

 private:
  bool is_last(std::size_t i) const { return i + 1 == path_.size(); }

  // Short of the limits by more than rounding, so that they are met.
  bool is_in_goal(const Pose2& pose) const {
    constexpr double kShort = 1.0 - 1e-6;
    return (pose.position() - task_.goal.position()).norm() <= kShort * task_.tolerance.position &&
           std::abs(normalized_angle(pose.yaw - task_.goal.yaw)) <= kShort * task_.tolerance.heading;
  }

  bool move(std::size_t i, double step) {
    const Pose2 at = path_[i];
    const Eigen::Vector2d along = step * Eigen::Vector2d(std::cos(at.yaw), std::sin(at.yaw));
    const double turn = step / task_.objective.steering()->turning_radius();
    const std::array<Pose2, 6> moves{{{at.x - along.y(), at.y + along.x(), at.yaw},
                                      {at.x + along.y(), at.y - along.x(), at.yaw},
                                      {at.x, at.y, at.yaw + turn},
                                      {at.x, at.y, at.yaw - turn},
                                      {at.x + along.x(), at.y + along.y(), at.yaw},
                                      {at.x - along.x(), at.y - along.y(), at.yaw}}};
    return std::ranges::any_of(moves, [&](const Pose2& to) { return try_pose(i, {to.x, to.y, normalized_angle(to.yaw)}); });
  }

  bool try_pose(std::size_t i, const Pose2& to) {
    if (is_last(i) && !is_in_goal(to)) return false;
    const double left = (1.0 - kWorthIt) * (costs_[i] + (is_last(i) ? 0.0 : costs_[i + 1]));
    const auto there = leg_below(left, task_, path_[i - 1], to);
    if (!there) return false;
    const auto on = is_last(i) ? std::nullopt : leg_below(left - there->cost, task_, to, path_[i + 1]);
    if (!is_last(i) && !on) return false;
    const Pose2 before = std::exchange(path_[i], to);
    if (!keeps_limits(path_, task_)) {
      path_[i] = before;
      return false;
    }
    costs_[i] = there->cost;
    if (on) costs_[i + 1] = on->cost;
    return true;
  }

  Poses path_;
  const CarTask& task_;
  std::vector<double> costs_;  // of getting to each from the one before
};

}  // namespace

std::vector<Pose2> refined(std::vector<Pose2> path, const CarTask& task, const StopTest& stop) {
  const Steering& steering = *task.objective.steering();
  const double radius = steering.turning_radius();
  const auto shorten = [&](double spacing) {
    if (auto shorter = with_shortcuts(subdivided(path, spacing, steering), task)) path = std::move(*shorter);
  };
  shorten(radius);
  // From coarse to fine. Nearer to one another than a radius, poses cannot be moved but for the arcs that they are joined by.
  for (const double spacing : {4.0 * radius, 2.0 * radius, radius}) {
    if (is_told_to_stop(stop)) break;
    path = Relaxation(subdivided(path, spacing, steering), task).run(0.25 * radius, stop);
    shorten(0.5 * radius);
  }
  return path;
}

}  // namespace alignability
