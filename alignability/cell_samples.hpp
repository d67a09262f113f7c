// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "costmap/occupancy_map.hpp"

namespace alignability {

/// Which cells of an alignability map are worth a value.
struct EvaluationRule {
  double occupied_above = 0.5;      ///< o_max, in [0,1]: an occupancy above it is occupied; unknown is too
  double max_occupied_share = 0.5;  ///< a cell is evaluated when at most this share of its area is occupied
};

/// The part of one α-cell that is free: pieces of occupancy cells, weighted by area where the grids do not divide each other.
class FreePart {
 public:
  FreePart(const OccupancyMap& occupancy, const GridGeometry& map, Cell cell, const EvaluationRule& rule);

  /// Whether so little is occupied that the cell is to be evaluated, and there is a place to be in.
  bool is_evaluated() const { return evaluated_; }

  /// The place at `share` in [0,1) of the free area, its pieces taken row after row; `u` and `v` in [0,1) say where in the piece.
  Eigen::Vector2d at(double share, double u, double v) const;

 private:
  struct Piece {
    Eigen::Vector2d low;
    Eigen::Vector2d size;
    double area_before;
  };

  std::vector<Piece> pieces_;
  double area_ = 0.0;
  bool evaluated_ = false;
};

}  // namespace alignability
