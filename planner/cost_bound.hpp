// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "planner/cost_lattice.hpp"

namespace alignability {

/// A certified lower bound of what ∫ (1 + w·risk) ds costs a robot that has to get to a disk, from anywhere: L, a continuous function over
/// the lattice's open cells, 0 at the disk, of whose gradient every open cell proves |∇L| ≤ 1 + w·risk. A drivable path stays in open
/// cells, so along it L changes by no more than it costs, to within rounding: L is at most the cost of getting to the disk, and |L(a) −
/// L(b)| at most that of getting from a to b. The latter is admissible, consistent and symmetric.
///
/// How: each cell's edges get lengths; L(node) is the shortest way over edges, by Dijkstra's algorithm, so that along no edge L changes by
/// more than the edge's length; within a cell L is interpolated. Let the lengths of a cell with sides h be at most h·n_x and h·n_y times
/// the mean of the cost c at the edge's ends, (n_x, n_y) a unit vector. L is made to grow along an edge in proportion to c as interpolated
/// between the ends, and is blended between opposite edges. Then |L_x| ≤ n_x·c and |L_y| ≤ n_y·c at the four corners; both are interpolated
/// linearly along each axis, and so is c; so |∇L| ≤ c throughout. Two corrections: CostLattice::share, where c is not bilinear
/// within the cell, and what blending adds where opposite edges differ in shape, at most an eighth of the ends' differences in cost.
///
/// Any unit vectors give a bound. Good ones share a cell's cost between the axes as the optimal cost grows along them, so lengths are
/// fast marching's differences, scaled in each cell to what the proof allows, and an edge takes the lesser of its two cells'. That loses
/// where the optimal cost is bent within a cell: docs/planners.md has figures. It gains with a finer map.
class CostBound {
 public:
  /// To within `tolerance` [m] of a place. O(cells).
  CostBound(std::shared_ptr<const CostLattice> lattice, const Eigen::Vector2d& place, double tolerance);

  /// [equivalent m]; infinite where no path leads to the disk, which is a proof, and outside of open cells.
  double operator()(const Eigen::Vector2d& point) const;

  /// At most the least that the sum of two bounds is in a cell.
  static double least_sum(const CostBound& a, const CostBound& b, std::size_t cell);

  const std::shared_ptr<const CostLattice>& shared_lattice() const { return lattice_; }

 private:
  /// The most by which it dips below the interpolation of the corners' values in a cell.
  double dip(std::size_t cell) const;

  std::shared_ptr<const CostLattice> lattice_;
  std::vector<double> at_node_;
};

}  // namespace alignability
