// SPDX-License-Identifier: BSD-3-Clause
#include "planner/limited_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>

namespace alignability {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kSpacings[] = {0.5, 0.25};  // of lattices, the next one where the last leads nowhere [m]
// Errors that differ by less than such a part of the limit count as one; the next part where that loses the way.
constexpr double kAlike[] = {0.02, 0.001};

// The sixteen ways to places up to two columns and rows away with none between.
constexpr std::array<Cell, 16> kSteps{{{1, 0},
                                       {2, 1},
                                       {1, 1},
                                       {1, 2},
                                       {0, 1},
                                       {-1, 2},
                                       {-1, 1},
                                       {-2, 1},
                                       {-1, 0},
                                       {-2, -1},
                                       {-1, -1},
                                       {-1, -2},
                                       {0, -1},
                                       {1, -2},
                                       {1, -1},
                                       {2, -1}}};

struct Edge {
  std::size_t to;
  double cost;
  double length;  // [m]
  ErrorModel::Change change;
};

// Places of a lattice, and after them the start and the goal.
class Lattice {
 public:
  Lattice(const PlanarMotion& motion, const ErrorModel& model, double spacing, const Eigen::Vector2d& start, const Eigen::Vector2d& goal)
      : motion_(motion),
        limit_{model, kInfinite},
        grid_(grid_over(motion.clearance->geometry(), spacing)),
        start_(start),
        goal_(goal),
        edges_(size()) {
    for (std::size_t node = 0; node < grid_.size(); ++node) {
      if (motion_.is_allowed(place(node), place(node))) connect(node);
    }
    connect_near(this->start());
    connect_near(this->goal());
    join(this->start(), this->goal());
  }

  std::size_t size() const { return grid_.size() + 2; }
  std::size_t start() const { return grid_.size(); }
  std::size_t goal() const { return grid_.size() + 1; }
  Eigen::Vector2d place(std::size_t node) const {
    return node == start() ? start_ : node == goal() ? goal_ : grid_.center(grid_.cell_of(node));
  }
  const std::vector<Edge>& edges(std::size_t node) const { return edges_[node]; }

 private:
  static GridGeometry grid_over(const GridGeometry& map, double spacing) {
    return {.resolution = spacing,
            .origin = map.origin,
            .width = std::max(1, static_cast<int>(map.extent().x() / spacing)),
            .height = std::max(1, static_cast<int>(map.extent().y() / spacing))};
  }

  void connect(std::size_t node) {
    const Cell cell = grid_.cell_of(node);
    for (const Cell& step : kSteps) {
      const Cell to{cell.x + step.x, cell.y + step.y};
      // Once for both directions.
      if (grid_.contains(to) && grid_.index(to) > node) join(node, grid_.index(to));
    }
  }

  void connect_near(std::size_t node) {
    constexpr int kReach = 2;
    const Eigen::Array2d at = ((place(node) - grid_.origin) / grid_.resolution).array().floor();
    for (int y = static_cast<int>(at.y()) - kReach; y <= at.y() + kReach; ++y) {
      for (int x = static_cast<int>(at.x()) - kReach; x <= at.x() + kReach; ++x) {
        if (grid_.contains({x, y})) join(node, grid_.index({x, y}));
      }
    }
  }

  void join(std::size_t a, std::size_t b) {
    if (!motion_.is_allowed(place(a), place(b))) return;
    const double cost = motion_.cost(place(a), place(b));
    const double length = (place(a) - place(b)).norm();
    edges_[a].push_back({b, cost, length, limit_.change(place(a), place(b), *motion_.risk)});
    edges_[b].push_back({a, cost, length, limit_.change(place(b), place(a), *motion_.risk)});
  }

  const PlanarMotion& motion_;
  ErrorLimit limit_;
  GridGeometry grid_;
  Eigen::Vector2d start_;
  Eigen::Vector2d goal_;
  std::vector<std::vector<Edge>> edges_;
};

using Waiting = std::pair<double, std::size_t>;
using Queue = std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>>;

// What getting to the goal costs where no limit is kept.
std::vector<double> costs_to_goal(const Lattice& lattice) {
  std::vector<double> to_go(lattice.size(), kInfinite);
  to_go[lattice.goal()] = 0.0;
  Queue queue;
  queue.push({0.0, lattice.goal()});
  while (!queue.empty()) {
    const auto [cost, node] = queue.top();
    queue.pop();
    if (cost > to_go[node]) continue;
    for (const Edge& edge : lattice.edges(node)) {
      if (cost + edge.cost >= to_go[edge.to]) continue;
      to_go[edge.to] = cost + edge.cost;
      queue.push({to_go[edge.to], edge.to});
    }
  }
  return to_go;
}

// A way to a place.
struct Label {
  std::size_t node;
  std::size_t before;  // the label it came from
  double cost;
  double error;
};

PlanarPath path_of(const Lattice& lattice, const std::vector<Label>& labels, std::size_t last) {
  PlanarPath path{lattice.place(labels[last].node)};
  for (std::size_t at = last; labels[at].node != lattice.start(); at = labels[at].before) {
    path.push_back(lattice.place(labels[labels[at].before].node));
  }
  std::ranges::reverse(path);
  return path;
}

// The error at the end of an edge; nullopt where the limit is broken on it.
std::optional<double> error_after(const Lattice& lattice, std::size_t from, const Edge& edge, double error, const PlanarMotion& motion,
                                  const ErrorLimit& limit) {
  // Nowhere does it grow faster.
  if (error + limit.model.growth * edge.length <= limit.most) return std::max(limit.model.least, edge.change.of(error));
  return limit.after(error, lattice.place(from), lattice.place(edge.to), *motion.risk);
}

// The least error with which the robot can be at each place, whatever it costs; infinite where it cannot be within the limit.
std::vector<double> surest_errors(const Lattice& lattice, const PlanarMotion& motion, const ErrorLimit& limit,
                                  const std::stop_token& stop) {
  constexpr double kWorthwhile = 1e-3;  // of the error: smaller improvements are not followed up
  std::vector<double> surest(lattice.size(), kInfinite);
  surest[lattice.start()] = limit.model.least;
  Queue queue;
  queue.push({limit.model.least, lattice.start()});
  while (!queue.empty() && !stop.stop_requested()) {
    const auto [error, node] = queue.top();
    queue.pop();
    if (error > surest[node]) continue;
    for (const Edge& edge : lattice.edges(node)) {
      const auto after = error_after(lattice, node, edge, error, motion, limit);
      if (!after || !(*after < (1.0 - kWorthwhile) * surest[edge.to])) continue;
      surest[edge.to] = *after;
      queue.push({*after, edge.to});
    }
  }
  return surest;
}

std::optional<PlanarPath> search(const Lattice& lattice, const PlanarMotion& motion, const ErrorLimit& limit, double alike,
                                 const std::stop_token& stop) {
  const std::vector<double> to_go = costs_to_goal(lattice);
  // Ways leave the queue in the order of their cost, so that one to a place where others were already is of use only if it is more sure.
  std::vector<double> surest(lattice.size(), kInfinite);
  const auto is_surer = [&](double error, std::size_t node) { return surest[node] == kInfinite || error < surest[node] - alike; };
  std::vector<Label> labels{{lattice.start(), 0, 0.0, limit.model.least}};
  Queue queue;
  queue.push({to_go[lattice.start()], 0});
  while (!queue.empty() && !stop.stop_requested()) {
    const std::size_t number = queue.top().second;
    queue.pop();
    const Label label = labels[number];
    if (label.node == lattice.goal()) return path_of(lattice, labels, number);
    if (!is_surer(label.error, label.node)) continue;
    surest[label.node] = label.error;
    for (const Edge& edge : lattice.edges(label.node)) {
      if (to_go[edge.to] == kInfinite) continue;
      const auto error = error_after(lattice, label.node, edge, label.error, motion, limit);
      if (!error || !is_surer(*error, edge.to)) continue;
      labels.push_back({edge.to, number, label.cost + edge.cost, *error});
      queue.push({labels.back().cost + to_go[edge.to], labels.size() - 1});
    }
  }
  return std::nullopt;
}

double cost_of(const PlanarPath& path, const PlanarMotion& motion) {
  double cost = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) cost += motion.cost(path[i - 1], path[i]);
  return cost;
}

// Leaves out vertices, the longest row of them first, as long as that makes the path no dearer and keeps the limit.
PlanarPath with_shortcuts(PlanarPath path, const PlanarMotion& motion, const ErrorLimit& limit) {
  constexpr std::size_t kWindow = 32;
  for (std::size_t i = 0; i + 2 < path.size(); ++i) {
    for (std::size_t k = std::min(path.size() - 1, i + kWindow); k > i + 1; --k) {
      const PlanarPath replaced(path.begin() + static_cast<std::ptrdiff_t>(i), path.begin() + static_cast<std::ptrdiff_t>(k) + 1);
      if (motion.cost(path[i], path[k]) > cost_of(replaced, motion) * (1.0 + 1e-9) || !motion.is_allowed(path[i], path[k])) continue;
      PlanarPath shorter = path;
      shorter.erase(shorter.begin() + static_cast<std::ptrdiff_t>(i) + 1, shorter.begin() + static_cast<std::ptrdiff_t>(k));
      if (!keeps(shorter, motion, limit)) continue;
      path = std::move(shorter);
      break;
    }
  }
  return path;
}

PlanarPath freed(PlanarPath path, const PlanarMotion& motion, const ErrorLimit& limit) {
  path = with_shortcuts(std::move(path), motion, limit);
  for (const double spacing : {2.0, 1.0, 0.5}) {
    path = subdivided(path, spacing, motion);
    relax(path, motion, 0.25 * spacing, [&](const PlanarPath& moved) { return keeps(moved, motion, limit); });
    path = with_shortcuts(std::move(path), motion, limit);
  }
  return path;
}

}  // namespace

bool keeps(const PlanarPath& path, const PlanarMotion& motion, const ErrorLimit& limit) {
  double error = limit.model.least;
  if (error > limit.most) return false;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const auto after = limit.after(error, path[i - 1], path[i], *motion.risk);
    if (!after) return false;
    error = *after;
  }
  return true;
}

std::optional<PlanarPath> path_within(const PlanarMotion& motion, const ErrorLimit& limit, const Eigen::Vector2d& start,
                                      const Eigen::Vector2d& goal, const std::stop_token& stop) {
  if (limit.model.least > limit.most) return std::nullopt;
  for (const double spacing : kSpacings) {
    const Lattice lattice(motion, limit.model, spacing, start, goal);
    if (surest_errors(lattice, motion, limit, stop)[lattice.goal()] == kInfinite) continue;
    for (const double share : kAlike) {
      const auto path = search(lattice, motion, limit, share * limit.most, stop);
      if (path) return freed(*path, motion, limit);
    }
  }
  return std::nullopt;
}

std::optional<double> smallest_limit(const PlanarMotion& motion, const ErrorModel& model, const Eigen::Vector2d& start,
                                     const Eigen::Vector2d& goal, const std::stop_token& stop) {
  const Lattice lattice(motion, model, kSpacings[1], start, goal);
  const auto does = [&](double most) { return surest_errors(lattice, motion, {model, most}, stop)[lattice.goal()] < kInfinite; };
  // No way over places of the lattice is longer than all of them are apart from one another's neighbours.
  const double most = model.least + model.growth * 3.0 * kSpacings[1] * static_cast<double>(lattice.size());
  double too_little = model.least;
  double enough = std::max(2.0 * model.least, 1e-3);
  for (; !does(enough); enough *= 2.0) {
    if (enough > most || stop.stop_requested()) return std::nullopt;
    too_little = enough;
  }
  while (enough - too_little > std::max(0.01 * enough, 1e-3)) {
    const double middle = 0.5 * (enough + too_little);
    (does(middle) ? enough : too_little) = middle;
  }
  return stop.stop_requested() ? std::nullopt : std::optional(enough);
}

}  // namespace alignability
