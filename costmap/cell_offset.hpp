// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "costmap/grid.hpp"

namespace alignability {

/// The cell of `grid`, on it or not, whose square is that of cell (0,0) of `other`; nullopt where the squares of the two do not coincide
/// to a thousandth of a cell.
inline std::optional<Cell> offset_of(const GridGeometry& other, const GridGeometry& grid) {
  constexpr double kTolerance = 1e-3;
  const Eigen::Array2d cells = (other.origin - grid.origin).array() / grid.resolution;
  const Eigen::Array2d whole = cells.round();
  const bool same_size = std::abs(other.resolution - grid.resolution) * std::max(grid.width, grid.height) <= kTolerance * grid.resolution;
  const bool representable = (whole.abs() < std::numeric_limits<int>::max() / 2).all();
  if (!same_size || !representable || (cells - whole).abs().maxCoeff() > kTolerance) return std::nullopt;
  return Cell{static_cast<int>(whole.x()), static_cast<int>(whole.y())};
}

}  // namespace alignability
