// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace alignability {

/// A convex polygon of the plane by its corners in order [m]; two corners are a segment, one is a point.
using ConvexPolygon = std::vector<Eigen::Vector2d>;

/// A piece of a region's boundary; the region lies to its left.
struct DirectedEdge {
  Eigen::Vector2d from;
  Eigen::Vector2d to;
};

/// What a horizontal band of a site shows from above, in `map` [m].
struct Slice {
  std::vector<ConvexPolygon> surfaces;    ///< surfaces within the band
  std::vector<DirectedEdge> solid_edges;  ///< boundaries of solids at the band's mid-height; winding number ≥ 1 is inside
  std::vector<ConvexPolygon> floors;      ///< surfaces below the band that a robot could stand on
};

}  // namespace alignability
