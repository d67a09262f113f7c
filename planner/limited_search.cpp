// SPDX-License-Identifier: BSD-3-Clause
#include "planner/limited_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>

namespace alignability::detail {
namespace {

using Waiting = std::pair<double, std::size_t>;
using Queue = std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>>;

GridGeometry grid_over(const GridGeometry& map, double spacing) {
  return {.resolution = spacing,
          .origin = map.origin,
          .width = std::max(1, static_cast<int>(map.extent().x() / spacing)),
          .height = std::max(1, static_cast<int>(map.extent().y() / spacing))};
}

// Of each place, the states that no other makes superfluous.
class Fronts {
 public:
  explicit Fronts(std::size_t nodes) : states_(nodes) {}

  bool would_improve(std::size_t node, const PathLimits::State& state, const PathLimits& limits, double alike) const {
    return std::ranges::none_of(states_[node], [&](const PathLimits::State& known) { return limits.is_no_worse(known, state, alike); });
  }
  bool improve(std::size_t node, const PathLimits::State& state, const PathLimits& limits, double alike) {
    if (!would_improve(node, state, limits, alike)) return false;
    std::erase_if(states_[node], [&](const PathLimits::State& known) { return limits.is_no_worse(state, known, 0.0); });
    states_[node].push_back(state);
    return true;
  }

 private:
  std::vector<std::vector<PathLimits::State>> states_;
};

}  // namespace

LimitedSearch::LimitedSearch(const PlanarMotion& motion, const PathLimits& limits, double spacing, const LimitedWay& way,
                             const StopTest& stop)
    : motion_(motion),
      limits_(limits),
      grid_(grid_over(motion.clearance->geometry(), spacing)),
      way_(way),
      stop_(stop),
      edges_(grid_.size() + 2) {
  for (std::size_t node = 0; node < grid_.size(); ++node) {
    stop_if(stop_);
    if (motion_.is_allowed(place(node), place(node))) connect(node);
  }
  connect_near(at_start(), kNear);
  connect_near(at_goal(), kNear + static_cast<int>(std::ceil(way.tolerance / spacing)));
  join(at_start(), at_goal());
}

std::optional<PlanarPath> LimitedSearch::any(const PathLimits& limits, double alike) const {
  return search(limits, alike, [&](const Label& label) { return limits.urgency(label.state); });
}

std::optional<PlanarPath> LimitedSearch::cheapest(double alike) const {
  const std::vector<double> to_go = costs_to_goal();
  return search(limits_, alike, [&](const Label& label) { return label.cost + to_go[label.node]; });
}

template <typename Rank>
std::optional<PlanarPath> LimitedSearch::search(const PathLimits& limits, double alike, Rank rank) const {
  Fronts fronts(edges_.size());
  std::vector<Label> labels{{at_start(), 0, 0.0, limits.at_start()}};
  Queue queue;
  queue.push({rank(labels.front()), 0});
  while (!queue.empty()) {
    stop_if(stop_);
    const std::size_t number = queue.top().second;
    queue.pop();
    const Label label = labels[number];
    if (label.node == at_goal()) return path_of(labels, number);
    if (!fronts.improve(label.node, label.state, limits, alike)) continue;
    for (const Edge& edge : edges_[label.node]) {
      const auto state = after(limits, label, edge);
      if (!state || !fronts.would_improve(edge.to, *state, limits, alike)) continue;
      const Label next{edge.to, number, label.cost + edge.cost, *state};
      const double order = rank(next);
      if (order == kInfinite) continue;
      labels.push_back(next);
      queue.push({order, labels.size() - 1});
    }
  }
  return std::nullopt;
}

Eigen::Vector2d LimitedSearch::place(std::size_t node) const {
  return node == at_start() ? way_.start : node == at_goal() ? way_.goal : grid_.center(grid_.cell_of(node));
}

// Sixteen ways, to places up to two columns and rows away with none between, of which eight are joined from either end.
void LimitedSearch::connect(std::size_t node) {
  constexpr std::array<Cell, 8> kSteps{{{1, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 1}, {-1, 2}, {-1, 1}, {-2, 1}}};
  const Cell cell = grid_.cell_of(node);
  for (const Cell& step : kSteps) {
    const Cell to{cell.x + step.x, cell.y + step.y};
    if (grid_.contains(to)) join(node, grid_.index(to));
  }
}

void LimitedSearch::connect_near(std::size_t node, int reach) {
  const Eigen::Array2d at = ((place(node) - grid_.origin) / grid_.resolution).array().floor();
  for (int y = static_cast<int>(at.y()) - reach; y <= at.y() + reach; ++y) {
    for (int x = static_cast<int>(at.x()) - reach; x <= at.x() + reach; ++x) {
      if (grid_.contains({x, y})) join(node, grid_.index({x, y}));
    }
  }
}

void LimitedSearch::join(std::size_t a, std::size_t b) {
  if (!motion_.is_allowed(place(a), place(b))) return;
  const double cost = motion_.cost(place(a), place(b));
  edges_[a].push_back({b, cost, limits_.change(place(a), end(a, b), *motion_.risk)});
  edges_[b].push_back({a, cost, limits_.change(place(b), end(b, a), *motion_.risk)});
}

// Of the way from one place to another, which at the goal ends as soon as it is within the tolerance.
Eigen::Vector2d LimitedSearch::end(std::size_t from, std::size_t to) const {
  return to == at_goal() ? cut_within({place(from), way_.goal}, way_.tolerance).back() : place(to);
}

std::optional<PathLimits::State> LimitedSearch::after(const PathLimits& limits, const Label& label, const Edge& edge) const {
  return limits.after(label.state, edge.change, place(label.node), end(label.node, edge.to), *motion_.risk);
}

// What getting to the goal costs where no limit is kept.
std::vector<double> LimitedSearch::costs_to_goal() const {
  std::vector<double> to_go(edges_.size(), kInfinite);
  to_go[at_goal()] = 0.0;
  Queue queue;
  queue.push({0.0, at_goal()});
  while (!queue.empty()) {
    const auto [cost, node] = queue.top();
    queue.pop();
    if (cost > to_go[node]) continue;
    for (const Edge& edge : edges_[node]) {
      if (cost + edge.cost >= to_go[edge.to]) continue;
      to_go[edge.to] = cost + edge.cost;
      queue.push({to_go[edge.to], edge.to});
    }
  }
  return to_go;
}

PlanarPath LimitedSearch::path_of(const std::vector<Label>& labels, std::size_t last) const {
  PlanarPath path{place(labels[last].node)};
  for (std::size_t at = last; labels[at].node != at_start(); at = labels[at].before) {
    path.push_back(place(labels[labels[at].before].node));
  }
  std::ranges::reverse(path);
  return path;
}

}  // namespace alignability::detail
