// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "costmap/grid.hpp"

namespace alignability::detail {

// The crossings of a segment with the grid lines of one axis, in the order they are met. Each is computed from the index of its line,
// so that no error builds up along the way.
class LineCrossings {
 public:
  LineCrossings(double from, double to, int cells) : from_(from), span_(to - from) {
    // The cast of what is not negative is its floor, and cheaper.
    const double inside = std::clamp<double>(from, 0.0, cells);
    const auto whole = static_cast<double>(static_cast<int>(inside));
    if (span_ > 0.0) {
      next_ = from < 0.0 ? 0.0 : whole + 1.0;
      step_ = 1.0;
      last_ = cells;
    } else if (span_ < 0.0) {
      next_ = from > cells ? cells : (whole == inside ? whole - 1.0 : whole);
      step_ = -1.0;
      last_ = 0.0;
    }
    meet();
  }

  /// The share of the segment, in (0,1), at which the next line is met; 1 when there is none.
  double share() const { return share_; }
  void advance() {
    next_ += step_;
    meet();
  }
  double at(double share) const { return from_ + share * span_; }

 private:
  void meet() {
    const bool exhausted = step_ == 0.0 || (last_ - next_) * step_ < 0.0;
    share_ = exhausted ? 1.0 : std::min(1.0, (next_ - from_) / span_);
  }

  double from_;
  double span_;
  double share_ = 1.0;
  double next_ = 0.0;
  double step_ = 0.0;
  double last_ = 0.0;
};

/// Calls `visit(cell, from_share, to_share)` for each piece of the segment that lies in one cell of a grid of that many columns and rows,
/// its cells 1 wide from (0, 0) on, in order. Cells beyond the grid are not told apart: their index is -1 or the width (height). A segment
/// of no length is one piece. O(cells crossed), no allocation.
template <typename Visitor>
void traverse_unit_cells(const Eigen::Vector2d& from, const Eigen::Vector2d& to, int width, int height, Visitor&& visit) {
  LineCrossings columns(from.x(), to.x(), width);
  LineCrossings rows(from.y(), to.y(), height);
  // NaN, which no cast to int survives, fails the comparison and counts as beyond the grid.
  const auto index = [](double at, int cells) { return at >= 0.0 ? static_cast<int>(std::min(at, static_cast<double>(cells))) : -1; };
  for (double done = 0.0; done < 1.0;) {
    const double column_share = columns.share();
    const double row_share = rows.share();
    const double next = std::max(done, std::min(column_share, row_share));
    if (next > done) {
      const double middle = 0.5 * (done + next);
      visit(Cell{index(columns.at(middle), width), index(rows.at(middle), height)}, done, next);
    }
    if (column_share <= next) columns.advance();
    if (row_share <= next) rows.advance();
    done = next;
  }
}

/// The same in a grid that lies anywhere.
template <typename Visitor>
void traverse(const GridGeometry& geometry, const Eigen::Vector2d& from, const Eigen::Vector2d& to, Visitor&& visit) {
  traverse_unit_cells((from - geometry.origin) / geometry.resolution, (to - geometry.origin) / geometry.resolution, geometry.width,
                      geometry.height, visit);
}

}  // namespace alignability::detail
