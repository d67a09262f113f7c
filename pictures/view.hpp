// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "costmap/grid.hpp"
#include "costmap/occupancy_map.hpp"
#include "pictures/page.hpp"

namespace alignability::detail {

/// A rectangle of the plane, x right and y up [m].
struct WorldBox {
  Eigen::Vector2d lower = Eigen::Vector2d::Zero();
  Eigen::Vector2d upper = Eigen::Vector2d::Zero();

  Eigen::Vector2d extent() const { return upper - lower; }
};

/// Where the plane lies on a page.
struct View {
  Rectangle frame;                                  ///< on whole pixels
  double scale = 1.0;                               ///< [px/m]
  Eigen::Vector2d lower = Eigen::Vector2d::Zero();  ///< what the frame's lower left corner shows [m]

  Eigen::Vector2d upper() const { return lower + Eigen::Vector2d(frame.width, frame.height) / scale; }
  /// Points far off the page are drawn in to what Cairo can represent.
  Eigen::Vector2d to_pixel(const Eigen::Vector2d& point) const;
  Rectangle to_pixels(const WorldBox& box) const;
};

/// The view of a box at `scale`, with a margin around where the frame would be too small to read. The frame's corner is (0, 0).
View view_of(const WorldBox& box, double scale);

/// The view of both a map's cells and its occupancy. Its longer side is about 1400 px, an occupancy cell a whole number of pixels where
/// it has any, and no cell larger than 120 px.
View view_of(const GridGeometry& cells, const OccupancyMap& occupancy);

inline constexpr double kLongSide = 1400.0;

}  // namespace alignability::detail
