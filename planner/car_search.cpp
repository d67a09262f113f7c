// SPDX-License-Identifier: BSD-3-Clause
#include "planner/car_search.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numbers>
#include <queue>
#include <unordered_map>

namespace alignability {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr int kHeadings = 72;
constexpr double kHeadingStep = 2.0 * std::numbers::pi / kHeadings;

class CarSearch {
 public:
  // `cell`: of the grid that tells places apart [m].
  CarSearch(const CarTask& task, const CostBound& to_go, double cell)
      : task_(task), to_go_(to_go), cell_(cell), radius_(task.objective.steering()->turning_radius()) {}

  std::optional<std::vector<Pose2>> run(const StopTest& stop) {
    constexpr std::size_t kBetweenLooks = 1024;
    reach(task_.start, 0.0, task_.limits.at_start(), kNone);
    for (std::size_t popped = 0; !front_.empty(); ++popped) {
      const auto [cost, node] = front_.top();
      front_.pop();
      if (cost >= cost_to_goal_) break;
      if (popped % kBetweenLooks == 0) stop_if(stop);
      const Node at = nodes_[node];
      if (!is_front(node)) continue;
      head_for_the_goal(at, node, popped);
      expand(at, node);
    }
    if (cost_to_goal_ == kInfinite) return std::nullopt;
    std::vector<Pose2> poses{task_.goal};
    for (std::uint32_t node = before_goal_; node != kNone; node = nodes_[node].before) poses.push_back(nodes_[node].pose);
    return std::vector<Pose2>{poses.rbegin(), poses.rend()};
  }

 private:
  struct Node {
    Pose2 pose;
    double cost;
    PathLimits::State state;
    std::uint32_t before;
    std::uint32_t next;  // of those of its key that no other makes superfluous
  };
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  std::uint64_t key(const Pose2& pose) const {
    const GridGeometry& map = task_.area.geometry();
    const auto column = static_cast<std::uint64_t>(std::max(0.0, (pose.x - map.origin.x()) / cell_));
    const auto row = static_cast<std::uint64_t>(std::max(0.0, (pose.y - map.origin.y()) / cell_));
    const auto heading = static_cast<std::uint64_t>(std::lround(normalized_angle(pose.yaw) / kHeadingStep) + kHeadings) % kHeadings;
    return (row << 32 | column) * kHeadings + heading;
  }

  // What is left to the goal, somewhat more than it must be.
  double still_to_go(const Pose2& pose) const {
    constexpr double kGreed = 1.1;
    const double in_plane = to_go_(pose.position());
    const double straight = (task_.goal.position() - pose.position()).norm();
    // A curve around no obstacles is longer than the straight way by a few radii at most.
    if (in_plane >= straight + 3.0 * std::numbers::pi * radius_) return kGreed * in_plane;
    const Curve curve = task_.objective.steering()->word(pose, task_.goal);
    return kGreed * std::max(in_plane, curve.length());
  }

  std::uint32_t first_of(std::uint64_t key) const {
    const auto found = fronts_.find(key);
    return found == fronts_.end() ? kNone : found->second;
  }

  bool is_front(std::uint32_t node) const {
    std::uint32_t other = first_of(key(nodes_[node].pose));
    while (other != kNone && other != node) other = nodes_[other].next;
    return other == node;
  }

  bool is_superfluous(std::uint64_t key, double cost, const PathLimits::State& state) const {
    for (std::uint32_t known = first_of(key); known != kNone; known = nodes_[known].next) {
      if (nodes_[known].cost <= cost && task_.limits.is_no_worse(nodes_[known].state, state, kAlikeToCars)) return true;
    }
    return false;
  }

  void drop_those_worse(std::uint64_t key, double cost, const PathLimits::State& state) {
    std::uint32_t* link = &fronts_.emplace(key, kNone).first->second;
    while (*link != kNone) {
      const Node& known = nodes_[*link];
      if (cost <= known.cost && task_.limits.is_no_worse(state, known.state, 0.0)) {
        *link = known.next;
      } else {
        link = &nodes_[*link].next;
      }
    }
  }

  void reach(const Pose2& pose, double cost, const PathLimits::State& state, std::uint32_t before) {
    const double to_go = still_to_go(pose);
    if (!(cost + to_go < cost_to_goal_)) return;
    drop_those_worse(key(pose), cost, state);
    std::uint32_t& first = fronts_.at(key(pose));
    const auto node = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({pose, cost, state, before, first});
    first = node;
    front_.emplace(cost + to_go, node);
  }

  void expand(const Node& at, std::uint32_t node) {
    // Out of the cell, or to another heading.
    const double length = std::max(1.5 * cell_, 1.01 * radius_ * kHeadingStep);
    for (const double sense : {1.0, -1.0}) {
      if (sense < 0.0 && !task_.objective.steering()->may_reverse()) return;
      for (const double bend : {0.0, 1.0, -1.0}) drive({at.pose, bend / radius_, sense * length}, at, node);
    }
  }

  void drive(const Arc& arc, const Node& at, std::uint32_t node) {
    const Pose2 end = arc.end();
    if (!task_.area.geometry().cell_near(end.position())) return;
    const double cost = at.cost + task_.objective.cost_of(arc);
    const auto state = task_.limits.after(at.state, arc, *task_.area.risk_field());
    if (!state || is_superfluous(key(end), cost, *state)) return;
    if (task_.area.contains(arc)) reach({end.x, end.y, normalized_angle(end.yaw)}, cost, *state, node);
  }

  // From near every time, from afar now and then.
  void head_for_the_goal(const Node& at, std::uint32_t node, std::size_t popped) {
    constexpr std::size_t kFarEvery = 16;
    const bool is_near = (task_.goal.position() - at.pose.position()).norm() < 6.0 * radius_;
    if (!is_near && popped % kFarEvery != 0) return;
    const auto leg = leg_below(cost_to_goal_ - at.cost, task_, at.pose, task_.goal);
    if (!leg || !task_.limits.after(at.state, leg->curve, *task_.area.risk_field())) return;
    cost_to_goal_ = at.cost + leg->cost;
    before_goal_ = node;
  }

  const CarTask& task_;
  const CostBound& to_go_;
  double cell_;
  double radius_;
  std::vector<Node> nodes_;
  std::unordered_map<std::uint64_t, std::uint32_t> fronts_;  // the first node of each key
  std::priority_queue<std::pair<double, std::uint32_t>, std::vector<std::pair<double, std::uint32_t>>, std::greater<>> front_;
  double cost_to_goal_ = kInfinite;
  std::uint32_t before_goal_ = kNone;
};

}  // namespace

std::optional<std::vector<Pose2>> search_car_path(const CarTask& task, const CostBound& to_go, const StopTest& stop) {
  const double resolution = task.area.geometry().resolution;
  const double coarsest = std::clamp(0.25 * task.objective.steering()->turning_radius(), resolution, std::max(resolution, 0.5));
  for (const double finer : {1.0, 2.0, 4.0}) {
    if (auto path = CarSearch(task, to_go, coarsest / finer).run(stop)) return path;
  }
  return std::nullopt;
}

}  // namespace alignability
