// SPDX-License-Identifier: BSD-3-Clause
#include "planner/goal_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>

namespace alignability {
namespace {

constexpr int kStride = 4;  // [cells] along either axis that a step down the field may take

template <typename Visit>
void visit_nodes_around(const DrivableLattice& lattice, const Eigen::Vector2d& at, Visit visit) {
  const GridGeometry& grid = lattice.grid;
  const Eigen::Array2d middle = ((at - grid.origin) / grid.resolution).array().round();
  for (int y = static_cast<int>(middle.y()) - kStride; y <= middle.y() + kStride; ++y) {
    for (int x = static_cast<int>(middle.x()) - kStride; x <= middle.x() + kStride; ++x) {
      if (grid.contains({x, y})) visit(grid.index({x, y}), grid.corner({x, y}));
    }
  }
  visit_places_around(lattice.passages, grid, at, kStride, [&](std::size_t i) { visit(grid.size() + i, lattice.passages.places[i]); });
}

}  // namespace

DrivableLattice::DrivableLattice(const PlanarMotion& of, const StopTest& stop) : motion(of) {
  const CostLattice lattice(*motion.risk, *motion.clearance, motion.weight, motion.radius, stop);
  grid = lattice.geometry;
  cost = drivable_costs(lattice, *motion.risk, *motion.clearance, motion.radius, stop);
  passages = passage_nodes(lattice, cost, motion, stop);
}

GoalField::GoalField(std::shared_ptr<const DrivableLattice> lattice, const Eigen::Vector2d& goal, const StopTest& stop)
    : lattice_(std::move(lattice)), goal_(goal) {
  std::vector<MarchingSeed> seeds;
  visit_nodes_around(*lattice_, goal, [&](std::size_t node, const Eigen::Vector2d& at) {
    const bool is_node = node >= lattice_->grid.size() || std::isfinite(lattice_->cost[node]);
    if (is_node && lattice_->motion.is_allowed(at, goal)) seeds.push_back({node, lattice_->motion.cost(at, goal)});
  });
  to_go_ = fast_marching(lattice_->grid, lattice_->cost, seeds, lattice_->passages.places.size(), lattice_->passages.links, stop);
}

std::optional<PlanarPath> GoalField::path_from(const Eigen::Vector2d& start) const {
  PlanarPath path{start};
  double below = std::numeric_limits<double>::infinity();
  const double in_reach = kStride * lattice_->grid.resolution;
  while (!((path.back() - goal_).norm() <= in_reach && lattice_->motion.is_allowed(path.back(), goal_))) {
    const auto step = best_step(path.back(), below);
    if (!step) return std::nullopt;
    below = step->to_go;
    path.push_back(step->to);
  }
  path.push_back(goal_);
  return path;
}

std::optional<GoalField::Step> GoalField::best_step(const Eigen::Vector2d& from, double below) const {
  std::optional<Step> best;
  visit_nodes_around(*lattice_, from, [&](std::size_t node, const Eigen::Vector2d& at) {
    const double to_go = to_go_[node];
    if (!(to_go < below)) return;
    const double cost = lattice_->motion.cost(from, at) + to_go;
    if ((!best || cost < best->cost) && lattice_->motion.is_allowed(from, at)) best = Step{cost, to_go, at};
  });
  return best;
}

namespace {

// A* over a lattice and its passages by motions priced one by one.
class DirectedSearch {
 public:
  DirectedSearch(const DrivableLattice& lattice, const std::vector<double>& to_go, const PlanarMotion& driven, const Eigen::Vector2d& goal)
      : lattice_(lattice), to_go_(to_go), driven_(driven), goal_(goal), nodes_(to_go.size()) {}

  std::optional<PlanarPath> run(const Eigen::Vector2d& start, const StopTest& stop) {
    constexpr std::size_t kBetweenLooks = 1024;
    best_ = straight(start);
    visit_nodes_around(lattice_, start, [&](std::size_t node, const Eigen::Vector2d&) { reach(node, start, 0.0, kNone); });
    for (std::size_t popped = 0; !front_.empty() && front_.top().first < best_; ++popped) {
      const auto [estimate, node] = front_.top();
      front_.pop();
      if (popped % kBetweenLooks == 0) stop_if(stop);
      if (estimate > nodes_[node].cost + to_go_[node]) continue;
      head_for_the_goal(node);
      expand(node);
    }
    if (best_ == kInfinite) return std::nullopt;
    PlanarPath path{goal_};
    for (std::size_t node = last_; node != kNone; node = nodes_[node].before) path.push_back(place(node));
    path.push_back(start);
    return PlanarPath{path.rbegin(), path.rend()};
  }

 private:
  struct Node {
    double cost = kInfinite;
    std::size_t before = kNone;
  };
  static constexpr double kInfinite = std::numeric_limits<double>::infinity();
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

  Eigen::Vector2d place(std::size_t node) const {
    const std::size_t cells = lattice_.grid.size();
    return node < cells ? lattice_.grid.corner(lattice_.grid.cell_of(node)) : lattice_.passages.places[node - cells];
  }

  double straight(const Eigen::Vector2d& start) const {
    const bool is_near = (start - goal_).norm() <= kStride * lattice_.grid.resolution;
    return is_near && driven_.is_allowed(start, goal_) ? driven_.cost(start, goal_) : kInfinite;
  }

  void reach(std::size_t node, const Eigen::Vector2d& from, double cost_before, std::size_t before) {
    if (!std::isfinite(to_go_[node])) return;
    const Eigen::Vector2d at = place(node);
    const double cost = cost_before + driven_.cost(from, at);
    if (cost >= nodes_[node].cost || cost + to_go_[node] >= best_ || !driven_.is_allowed(from, at)) return;
    nodes_[node] = {cost, before};
    front_.emplace(cost + to_go_[node], node);
  }

  void expand(std::size_t node) {
    const GridGeometry& grid = lattice_.grid;
    const Eigen::Vector2d from = place(node);
    for (const MarchingLink& link : std::ranges::equal_range(lattice_.passages.links, node, {}, &MarchingLink::from)) {
      reach(link.to, from, nodes_[node].cost, node);
    }
    if (node >= grid.size()) return;
    const Cell at = grid.cell_of(node);
    for (int y = -kReach; y <= kReach; ++y) {
      for (int x = -kReach; x <= kReach; ++x) {
        const Cell next{at.x + x, at.y + y};
        // Other steps go over a node on their way.
        if (std::gcd(x, y) == 1 && grid.contains(next)) reach(grid.index(next), from, nodes_[node].cost, node);
      }
    }
  }

  void head_for_the_goal(std::size_t node) {
    const double cost = nodes_[node].cost + straight(place(node));
    if (cost >= best_) return;
    best_ = cost;
    last_ = node;
  }

  static constexpr int kReach = 3;  // [cells] along either axis: 32 directions

  const DrivableLattice& lattice_;
  const std::vector<double>& to_go_;
  const PlanarMotion& driven_;
  Eigen::Vector2d goal_;
  std::vector<Node> nodes_;
  std::priority_queue<std::pair<double, std::size_t>, std::vector<std::pair<double, std::size_t>>, std::greater<>> front_;
  double best_ = kInfinite;
  std::size_t last_ = kNone;
};

}  // namespace

std::optional<PlanarPath> GoalField::directed_path_from(const Eigen::Vector2d& start, const PlanarMotion& driven,
                                                        const StopTest& stop) const {
  return DirectedSearch(*lattice_, to_go_, driven, goal_).run(start, stop);
}

std::optional<PlanarPath> steepest_path(const PlanarMotion& motion, const Eigen::Vector2d& start, const Eigen::Vector2d& goal,
                                        const StopTest& stop) {
  return GoalField(std::make_shared<const DrivableLattice>(motion, stop), goal, stop).path_from(start);
}

}  // namespace alignability
