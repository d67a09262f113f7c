// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>

#include "planner/cost_lattice.hpp"

namespace alignability {
namespace detail {

/// How a cell's inside is made of its edges.
enum class Inside : std::uint8_t {
  none,     ///< not open, or cut off
  blended,  ///< between edges that may be bent
  rising,   ///< two planes that meet on the diagonal from the lower left, between straight edges
  falling,  ///< on the other diagonal
};

}  // namespace detail

/// A certified lower bound of what ∫ (1 + w·risk) ds, the risk that of all sources at the best heading, costs a robot that has to get to a
/// disk, from anywhere: L, a continuous function over the lattice's open cells, 0 at the disk, of whose gradient every open cell proves
/// |∇L| ≤ 1 + w·risk. A drivable path stays in open cells, so along it L changes by no more than it costs, to within rounding: L is at most
/// the cost of getting to the disk, and |L(a) − L(b)| at most that of getting from a to b. The latter is admissible, consistent and
/// symmetric.
///
/// How: along each edge of the lattice L may grow by no more than a limit, one for either direction; L(node) is the least that limits add
/// up to from the disk, by Dijkstra's algorithm. Between its ends L is linear along an edge but for β·(t² − t), t the share of the edge and
/// β fixed before; within a cell it is blended: with corners' values interpolated bilinearly, N, and the lower edge's β_b, and so on,
///
///     L = N + (x² − x)·((1 − y)·β_b + y·β_t) + (y² − y)·((1 − x)·β_l + x·β_r),   x and y in [0, 1],
///     ∇L = Σ B_k·g_k + ((y² − y)·(β_r − β_l), (x² − x)·(β_t − β_b)),
///
/// B_k the corners' bilinear weights and g_k the slopes, at corner k, of the two edges that meet there: growth − β where an edge begins,
/// growth + β where it ends. The last term, the lean, is no longer than ¼·|(β_r − β_l, β_t − β_b)|. With |g_k| ≤ share·c_k·h − lean at
/// every corner, h a cell's side and c_k the cost there, |∇L| ≤ Σ B_k·share·c_k·h, which is at most the cost: see CostLattice::share. The
/// limits are such that |g_k| is at most that however L grows within them.
///
/// A cell through which a front's kink runs is made of two planes instead, which meet on a diagonal, between edges with β = 0. A plane's
/// gradient is the slopes of the two edges that bound it, held to share·h times the least of the corners' costs.
///
/// Any β and any division of a corner's slope between the axes give a bound. Good ones are fast marching's: β from how its growth changes
/// from edge to edge, slopes divided as it grows, so that a curved front costs little. What is lost is lost where fronts have kinks and at
/// the corners that they fan out from: docs/planners.md has figures. It gains with a finer map.
class CostBound {
 public:
  /// To within `tolerance` [m] of a place. O(cells). Throws Interrupted.
  CostBound(std::shared_ptr<const CostLattice> lattice, const Eigen::Vector2d& place, double tolerance, const StopTest& stop = {});

  /// [equivalent m]; infinite where no path leads to the disk, which is a proof, and outside of open cells.
  double operator()(const Eigen::Vector2d& point) const;

  /// At most the least that the sum of two bounds is in a cell; infinite where one is.
  static double least_sum(const CostBound& a, const CostBound& b, std::size_t cell);

  const std::shared_ptr<const CostLattice>& shared_lattice() const { return lattice_; }

 private:
  struct Node {
    double value;
    float bend_right;  // β of the edges that leave the node to the right and upwards
    float bend_up;
  };

  /// The most by which it dips below the interpolation of the corners' values in a cell.
  double dip(std::size_t cell) const;

  std::shared_ptr<const CostLattice> lattice_;
  std::vector<Node> nodes_;
  std::vector<detail::Inside> insides_;
};

}  // namespace alignability
