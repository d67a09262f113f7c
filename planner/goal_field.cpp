// SPDX-License-Identifier: BSD-3-Clause
#include "planner/goal_field.hpp"

#include <cmath>
#include <limits>

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

DrivableLattice::DrivableLattice(const PlanarMotion& of) : motion(of) {
  const CostLattice lattice(*motion.risk, *motion.clearance, motion.weight, motion.radius);
  grid = lattice.geometry;
  cost = drivable_costs(lattice, *motion.risk, *motion.clearance, motion.radius);
  passages = passage_nodes(lattice, cost, motion);
}

GoalField::GoalField(std::shared_ptr<const DrivableLattice> lattice, const Eigen::Vector2d& goal)
    : lattice_(std::move(lattice)), goal_(goal) {
  std::vector<MarchingSeed> seeds;
  visit_nodes_around(*lattice_, goal, [&](std::size_t node, const Eigen::Vector2d& at) {
    const bool is_node = node >= lattice_->grid.size() || std::isfinite(lattice_->cost[node]);
    if (is_node && lattice_->motion.is_allowed(at, goal)) seeds.push_back({node, lattice_->motion.cost(at, goal)});
  });
  to_go_ = fast_marching(lattice_->grid, lattice_->cost, seeds, lattice_->passages.places.size(), lattice_->passages.links);
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

std::optional<PlanarPath> steepest_path(const PlanarMotion& motion, const Eigen::Vector2d& start, const Eigen::Vector2d& goal) {
  return GoalField(std::make_shared<const DrivableLattice>(motion), goal).path_from(start);
}

}  // namespace alignability
