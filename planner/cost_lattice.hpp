// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/progress.hpp"
#include "costmap/clearance_map.hpp"
#include "costmap/risk_field.hpp"

namespace alignability {

/// What fast marching and bounds run on: what a metre costs at the corners of a map's cells, and which cells a robot may be in. Where risk
/// depends on heading, that of the best one counts (see RiskField::least_risk), so that a bound holds for any.
struct CostLattice {
  /// Of a robot that holds a disk of that radius [m] around `base_link`; weight >= 0. O(cells). Throws Interrupted.
  CostLattice(const RiskField& risk, const ClearanceMap& clearance, double weight, double radius, const StopTest& stop = {});

  /// Node (x, y) is its corner({x, y}), and the lower left corner of its cell (x, y). The map's cells begin at (1, 1): a ring is left
  /// around them, in which nothing is open, so that no neighbour of an open cell is missing.
  GridGeometry geometry;
  /// 1 + w·(the least risk) at the corners of open cells, infinite elsewhere.
  std::vector<float> cost;
  /// Of a cell: the greatest factor in [0,1] by which the bilinear interpolation of its corners' cost is nowhere above the cost; 0 where
  /// the cell is not open, that is, where no point of it can be drivable.
  std::vector<float> share;

  bool is_open(std::size_t cell) const { return share[cell] > 0.0f; }
};

/// The cost at the nodes where the robot's disk fits and the risk's policy lets it be, infinite elsewhere. Throws Interrupted.
std::vector<float> drivable_costs(const CostLattice& lattice, const RiskField& risk, const ClearanceMap& clearance, double radius,
                                  const StopTest& stop = {});

/// The greatest finite one; at least 1.
double dearest(std::span<const float> cost);

struct MarchingSeed {
  std::size_t node;
  double cost;
};

/// A way from one node to another, one that is no neighbour along an axis or none of the lattice's.
struct MarchingLink {
  std::size_t from;
  std::size_t to;
  double cost;
};

/// The cost of getting to each node from the seeds, by fast marching (Sethian 1996; Godunov's upwind differences, first order): near the
/// optimum, as a rule above it, no bound of it. Infinite where nothing leads. `cost` has a ring of infinite values. O(nodes). Throws
/// Interrupted.
std::vector<double> fast_marching(const GridGeometry& geometry, std::span<const float> cost, std::span<const MarchingSeed> seeds,
                                  const StopTest& stop = {});
/// The same with `more` nodes beside the lattice's, numbered on, that links alone lead to and from; these in the order of `from`.
std::vector<double> fast_marching(const GridGeometry& geometry, std::span<const float> cost, std::span<const MarchingSeed> seeds,
                                  std::size_t more, std::span<const MarchingLink> links, const StopTest& stop = {});

}  // namespace alignability
