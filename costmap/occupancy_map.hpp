// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "core/polygon.hpp"
#include "costmap/grid.hpp"

namespace alignability {

/// The probability that a cell is occupied, or that nothing is known of it. A cell is *free* when it is known and its occupancy is
/// at most `kOccupiedAbove`; everything else, the world beyond the map included, is not.
class OccupancyMap {
 public:
  static constexpr float kOccupiedAbove = 0.5f;

  OccupancyMap() = default;
  /// `occupancy` in [0,1], NaN = unknown; throws std::invalid_argument for any other value.
  explicit OccupancyMap(Grid<float> occupancy);

  const GridGeometry& geometry() const { return occupancy_.geometry(); }
  /// nullopt = unknown. The cell must lie on the map.
  std::optional<float> occupancy(Cell cell) const;
  bool is_free(Cell cell) const { return geometry().contains(cell) && is_free(geometry().index(cell)); }
  bool is_free(std::size_t index) const { return occupancy_[index] <= kOccupiedAbove; }

 private:
  Grid<float> occupancy_;
};

/// Occupied (1) where a surface of the slice touches a cell or a solid holds its centre; free (0) where a floor lies beneath the
/// centre and neither is the case; else unknown. A cell owns its left and lower edge. O(cells covered).
OccupancyMap rasterize(const Slice& slice, const GridGeometry& geometry);

/// The smallest grid of that resolution, its corners on whole cells counted from the origin of `map`, that holds every surface of the
/// slice. Throws std::invalid_argument for a slice without surfaces, or one of more than 2^31 cells.
GridGeometry geometry_around(const Slice& slice, double resolution);

}  // namespace alignability
