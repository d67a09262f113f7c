// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/progress.hpp"
#include "planner/cost_lattice.hpp"
#include "planner/passage_nodes.hpp"
#include "planner/planar_path.hpp"

namespace alignability {

/// Where a disk can be driven, as a lattice that fields are marched on: what all goals share. Immutable.
struct DrivableLattice {
  /// O(cells). Throws Interrupted.
  explicit DrivableLattice(const PlanarMotion& motion, const StopTest& stop = {});

  PlanarMotion motion;
  GridGeometry grid;
  std::vector<float> cost;
  PassageNodes passages;
};

/// The optimal cost-to-go to one place: near the optimum of all paths by as much as fast marching is. Immutable.
class GoalField {
 public:
  /// The goal must be allowed. O(cells). Throws Interrupted.
  GoalField(std::shared_ptr<const DrivableLattice> lattice, const Eigen::Vector2d& goal, const StopTest& stop = {});

  /// The path down the field, from node to node of the lattice and of its narrow passages, each motion allowed; nullopt where none leads.
  /// The start must be allowed. O(length).
  std::optional<PlanarPath> path_from(const Eigen::Vector2d& start) const;

  /// The path for motions that cost something else one way than the other: those of `driven`, at least what the lattice's cost. By A* from
  /// node to node, guided by the field: near the cheapest on the lattice. nullopt likewise. Throws Interrupted.
  std::optional<PlanarPath> directed_path_from(const Eigen::Vector2d& start, const PlanarMotion& driven, const StopTest& stop = {}) const;

 private:
  // Ordered by cost: of getting from a place straight to some node and on from there.
  struct Step {
    double cost;
    double to_go;
    Eigen::Vector2d to;
  };

  std::optional<Step> best_step(const Eigen::Vector2d& from, double below) const;

  std::shared_ptr<const DrivableLattice> lattice_;
  Eigen::Vector2d goal_;
  std::vector<double> to_go_;  // by node
};

/// The path down the optimal cost-to-go from a start to a goal. Both places must be allowed. O(cells). Throws
/// Interrupted.
std::optional<PlanarPath> steepest_path(const PlanarMotion& motion, const Eigen::Vector2d& start, const Eigen::Vector2d& goal,
                                        const StopTest& stop = {});

}  // namespace alignability
