// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <queue>
#include <stop_token>
#include <vector>

#include "planner/limited_path.hpp"

namespace alignability::detail {

/// A search for ways on which a limit is kept that depends on the way so far, as what comes of a place depends on the state in which the
/// robot gets there. A `Limit` has
///
///     using State, Change;
///     State at_start() const;
///     Change change(from, to, risk) const;                                        // of a straight way, to be kept
///     std::optional<State> after(state, change, from, to, risk) const;            // nullopt where the limit is broken on it
///     bool is_no_worse(const State& one, const State& other, double alike) const; // but for such a share of what the limit allows
///     double urgency(const State& state) const;                                   // the less, the sooner followed in search of any way
///
/// `is_no_worse` must hold on: whatever straight way is taken from there, of two such states the one stays no worse.
template <typename Limit>
class LimitedSearch {
 public:
  /// Over places every `spacing` metres. Start and goal must be allowed. Within the tolerance of the goal the limit need not be kept: the
  /// way ends there. O(area / spacing²), some 500 bytes a place.
  LimitedSearch(const PlanarMotion& motion, const Limit& limit, double spacing, const LimitedWay& way)
      : motion_(motion), limit_(limit), grid_(grid_over(motion.clearance->geometry(), spacing)), way_(way), edges_(grid_.size() + 2) {
    for (std::size_t node = 0; node < grid_.size(); ++node) {
      if (motion_.is_allowed(place(node), place(node))) connect(node);
    }
    connect_near(at_start(), kNear);
    connect_near(at_goal(), kNear + static_cast<int>(std::ceil(way.tolerance / spacing)));
    join(at_start(), at_goal());
  }

  /// Some way that keeps a limit; nullopt where there is none, and when stopped.
  std::optional<PlanarPath> any(const Limit& limit, double alike, const std::stop_token& stop) const {
    return search(limit, alike, stop, [&](const Label& label) { return limit.urgency(label.state); });
  }

  /// The cheapest way that keeps the limit, but for what `alike` costs; nullopt where there is none, and when stopped. By A* over labels, a
  /// place and a state each, those dropped that another at the place makes superfluous (Handler and Zang 1980).
  std::optional<PlanarPath> cheapest(double alike, const std::stop_token& stop) const {
    const std::vector<double> to_go = costs_to_goal();
    return search(limit_, alike, stop, [&](const Label& label) { return label.cost + to_go[label.node]; });
  }

 private:
  static constexpr int kNear = 2;  // [places] along either axis that start and goal are joined to
  static constexpr double kInfinite = std::numeric_limits<double>::infinity();

  using State = typename Limit::State;
  using Waiting = std::pair<double, std::size_t>;
  using Queue = std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>>;

  struct Edge {
    std::size_t to;
    double cost;
    typename Limit::Change change;
  };

  // A way to a place.
  struct Label {
    std::size_t node;
    std::size_t before;  // the label it came from
    double cost;
    State state;
  };

  // Of each place, the states that no other makes superfluous.
  class Fronts {
   public:
    explicit Fronts(std::size_t nodes) : states_(nodes) {}

    bool would_improve(std::size_t node, const State& state, const Limit& limit, double alike) const {
      return std::ranges::none_of(states_[node], [&](const State& known) { return limit.is_no_worse(known, state, alike); });
    }
    bool improve(const Label& label, const Limit& limit, double alike) {
      if (!would_improve(label.node, label.state, limit, alike)) return false;
      std::erase_if(states_[label.node], [&](const State& known) { return limit.is_no_worse(label.state, known, 0.0); });
      states_[label.node].push_back(label.state);
      return true;
    }

   private:
    std::vector<std::vector<State>> states_;
  };

  // Follows labels in the order of their rank, those of infinite rank not at all.
  template <typename Rank>
  std::optional<PlanarPath> search(const Limit& limit, double alike, const std::stop_token& stop, Rank rank) const {
    Fronts fronts(edges_.size());
    std::vector<Label> labels{{at_start(), 0, 0.0, limit.at_start()}};
    Queue queue;
    queue.push({rank(labels.front()), 0});
    while (!queue.empty() && !stop.stop_requested()) {
      const std::size_t number = queue.top().second;
      queue.pop();
      const Label label = labels[number];
      if (label.node == at_goal()) return path_of(labels, number);
      if (!fronts.improve(label, limit, alike)) continue;
      for (const Edge& edge : edges_[label.node]) {
        const auto state = after(limit, label, edge);
        if (!state || !fronts.would_improve(edge.to, *state, limit, alike)) continue;
        const Label next{edge.to, number, label.cost + edge.cost, *state};
        const double order = rank(next);
        if (order == kInfinite) continue;
        labels.push_back(next);
        queue.push({order, labels.size() - 1});
      }
    }
    return std::nullopt;
  }

  std::size_t at_start() const { return grid_.size(); }
  std::size_t at_goal() const { return grid_.size() + 1; }
  Eigen::Vector2d place(std::size_t node) const {
    return node == at_start() ? way_.start : node == at_goal() ? way_.goal : grid_.center(grid_.cell_of(node));
  }

  static GridGeometry grid_over(const GridGeometry& map, double spacing) {
    return {.resolution = spacing,
            .origin = map.origin,
            .width = std::max(1, static_cast<int>(map.extent().x() / spacing)),
            .height = std::max(1, static_cast<int>(map.extent().y() / spacing))};
  }

  // Sixteen ways, to places up to two columns and rows away with none between, of which eight are joined from either end.
  void connect(std::size_t node) {
    constexpr std::array<Cell, 8> kSteps{{{1, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 1}, {-1, 2}, {-1, 1}, {-2, 1}}};
    const Cell cell = grid_.cell_of(node);
    for (const Cell& step : kSteps) {
      const Cell to{cell.x + step.x, cell.y + step.y};
      if (grid_.contains(to)) join(node, grid_.index(to));
    }
  }

  void connect_near(std::size_t node, int reach) {
    const Eigen::Array2d at = ((place(node) - grid_.origin) / grid_.resolution).array().floor();
    for (int y = static_cast<int>(at.y()) - reach; y <= at.y() + reach; ++y) {
      for (int x = static_cast<int>(at.x()) - reach; x <= at.x() + reach; ++x) {
        if (grid_.contains({x, y})) join(node, grid_.index({x, y}));
      }
    }
  }

  void join(std::size_t a, std::size_t b) {
    if (!motion_.is_allowed(place(a), place(b))) return;
    const double cost = motion_.cost(place(a), place(b));
    edges_[a].push_back({b, cost, limit_.change(place(a), end(a, b), *motion_.risk)});
    edges_[b].push_back({a, cost, limit_.change(place(b), end(b, a), *motion_.risk)});
  }

  // Of the way from one place to another, which at the goal ends as soon as it is within the tolerance.
  Eigen::Vector2d end(std::size_t from, std::size_t to) const {
    return to == at_goal() ? cut_within({place(from), way_.goal}, way_.tolerance).back() : place(to);
  }

  std::optional<State> after(const Limit& limit, const Label& label, const Edge& edge) const {
    return limit.after(label.state, edge.change, place(label.node), end(label.node, edge.to), *motion_.risk);
  }

  // What getting to the goal costs where no limit is kept.
  std::vector<double> costs_to_goal() const {
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

  PlanarPath path_of(const std::vector<Label>& labels, std::size_t last) const {
    PlanarPath path{place(labels[last].node)};
    for (std::size_t at = last; labels[at].node != at_start(); at = labels[at].before) {
      path.push_back(place(labels[labels[at].before].node));
    }
    std::ranges::reverse(path);
    return path;
  }

  const PlanarMotion& motion_;
  Limit limit_;
  GridGeometry grid_;
  LimitedWay way_;
  std::vector<std::vector<Edge>> edges_;
};

}  // namespace alignability::detail
