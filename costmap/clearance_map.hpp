// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/arc.hpp"
#include "costmap/grid.hpp"
#include "costmap/occupancy_map.hpp"

namespace alignability {

/// The exact Euclidean distance from any point to the nearest cell that is not free, taken as a closed square; everything beyond the
/// map is not free. Immutable; queries are safe from many threads and allocate nothing.
class ClearanceMap {
 public:
  /// O(cells · log cells).
  explicit ClearanceMap(const OccupancyMap& occupancy);

  const GridGeometry& geometry() const { return center_distance_.geometry(); }

  /// [m]; 0 in and on a cell that is not free and off the map. O(distance / resolution).
  double distance(const Eigen::Vector2d& point) const;
  /// Whether a disk fits there: distance(point) >= radius, touching allowed but for a radius of 0. Mostly O(1).
  bool is_clear(const Eigen::Vector2d& point, double radius) const;
  /// Whether a disk fits at every point of the segment, exactly: no sampling. O(length / clearance), at worst O(length · radius² /
  /// resolution³).
  bool is_clear(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double radius) const;

  /// Whether a disk fits at every point of the arc: refused where it comes nearer than a thousandth of a cell, never allowed where it does
  /// not fit. Chords, their disks grown by the bulge, halved until that tells.
  bool is_clear(const Arc& arc, double radius) const;

  /// Whether the convex hull of some points, grown by `margin` [m] along both axes, lies on free cells alone; brushing others by less
  /// than a billionth of a cell is allowed. O(cells covered · points²).
  bool is_clear(std::span<const Eigen::Vector2d> hull, double margin) const;

  /// False off the map.
  bool is_free(Cell cell) const { return geometry().contains(cell) && column_gap_[cell] != 0; }
  /// distance() at the cell's centre.
  double distance_at(Cell cell) const { return center_distance_[cell]; }

 private:
  double border_distance(const Eigen::Vector2d& point) const;
  bool is_clear_of_cells(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double radius) const;

  Grid<std::int32_t> column_gap_;  // rows to the nearest cell of the same column that is not free; none: height
  Grid<float> center_distance_;    // [m], rounded down
};

}  // namespace alignability
