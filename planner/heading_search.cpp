// SPDX-License-Identifier: BSD-3-Clause
#include "planner/heading_search.hpp"

#include <algorithm>
#include <limits>
#include <queue>

namespace alignability {
namespace {

constexpr int kHeadings = 72;
constexpr double kSpacing = 0.3;  // [m] at most between places

// Short of the limit by more than rounding, so that it is met.
double turn_needed(double from, const HeadingEnds& ends) {
  const double turn = normalized_angle(ends.goal - from);
  return std::copysign(std::max(0.0, std::abs(turn) - (1.0 - 1e-6) * ends.tolerance), turn);
}

// The way of the least price through places × headings. Node `end()` stands for the goal's heading at the last place.
class HeadingSearch {
 public:
  HeadingSearch(PlanarPath places, const HeadingEnds& ends, const DrivableArea& area, const HeadingPrice& price)
      : places_(std::move(places)), ends_(ends), area_(area), price_(price), nodes_(places_.size() * kHeadings + 1) {}

  std::optional<std::vector<Pose2>> run() {
    improve(0, 0.0, 0);
    while (!front_.empty()) {
      const auto [cost, node] = front_.top();
      front_.pop();
      if (node == end()) return poses_to_end();
      if (cost <= nodes_[node].cost) expand(node);
    }
    return std::nullopt;
  }

 private:
  struct Node {
    double cost = std::numeric_limits<double>::infinity();
    std::size_t before = 0;
  };

  std::size_t end() const { return nodes_.size() - 1; }

  Pose2 pose(std::size_t node) const {
    const Eigen::Vector2d& at = places_[node / kHeadings];
    return {at.x(), at.y(), ends_.start + kStep * static_cast<double>(node % kHeadings)};
  }

  double price(const Pose2& from, const Pose2& to, double turned) const {
    const double of_risk = price_.of_risk == 0.0 ? 0.0 : price_.of_risk * area_.risk_field()->integral(from, to);
    return price_.of_turning * turned + of_risk;
  }

  void improve(std::size_t node, double cost, std::size_t before) {
    nodes_[node] = {cost, before};
    front_.emplace(cost, node);
  }

  void expand(std::size_t node) {
    const std::size_t place = node / kHeadings;
    turn(node, place, {-1, 1});
    if (place + 1 < places_.size()) {
      turn(node, place + 1, {-2, -1, 0, 1, 2});
    } else {
      finish(node);
    }
  }

  void turn(std::size_t node, std::size_t place, std::initializer_list<int> steps) {
    for (const int by : steps) {
      const std::size_t next = place * kHeadings + (node % kHeadings + static_cast<std::size_t>(kHeadings + by)) % kHeadings;
      const double cost = nodes_[node].cost + price(pose(node), pose(next), std::abs(by) * kStep);
      if (cost < nodes_[next].cost && area_.contains(pose(node), pose(next))) improve(next, cost, node);
    }
  }

  void finish(std::size_t node) {
    const Pose2 at = pose(node);
    const double by = turn_needed(at.yaw, ends_);
    const double cost = nodes_[node].cost + price_.of_turning * std::abs(by);
    if (cost < nodes_[end()].cost && area_.contains(at, {at.x, at.y, at.yaw + by})) improve(end(), cost, node);
  }

  std::vector<Pose2> poses_to_end() const {
    std::size_t node = nodes_[end()].before;
    Pose2 last = pose(node);
    last.yaw += turn_needed(last.yaw, ends_);
    std::vector<Pose2> poses{last};
    for (; node != 0; node = nodes_[node].before) poses.push_back(pose(node));
    poses.push_back(pose(0));
    return {poses.rbegin(), poses.rend()};
  }

  static constexpr double kStep = radians(360.0 / kHeadings);

  PlanarPath places_;
  HeadingEnds ends_;
  const DrivableArea& area_;
  HeadingPrice price_;
  std::vector<Node> nodes_;
  std::priority_queue<std::pair<double, std::size_t>, std::vector<std::pair<double, std::size_t>>, std::greater<>> front_;
};

}  // namespace

std::vector<Pose2> turning_evenly(const PlanarPath& path, const HeadingEnds& ends) {
  double length = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) length += (path[i] - path[i - 1]).norm();
  const double turn = turn_needed(ends.start, ends);
  std::vector<Pose2> poses{{path.front().x(), path.front().y(), ends.start}};
  double done = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    done += (path[i] - path[i - 1]).norm();
    poses.push_back({path[i].x(), path[i].y(), ends.start + turn * done / length});
  }
  if (length == 0.0 && turn != 0.0) poses.push_back({path.back().x(), path.back().y(), ends.start + turn});
  return poses;
}

std::optional<std::vector<Pose2>> turning_clear(const PlanarPath& path, const HeadingEnds& ends, const DrivableArea& area,
                                                const HeadingPrice& price) {
  return HeadingSearch(subdivided(path, kSpacing), ends, area, price).run();
}

}  // namespace alignability
