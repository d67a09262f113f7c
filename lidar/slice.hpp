// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/polygon.hpp"
#include "lidar/disc_cloud.hpp"
#include "lidar/triangle_mesh.hpp"

namespace alignability {

/// What lies between two heights of `map` [m], z_min < z_max, seen from above: polygons counter-clockwise, a vertical wall as a segment.
/// `surfaces` are the parts of triangles with z in [z_min, z_max], each 0.1 mm to its inside, so that a wall that ends on a cell's edge
/// does not spill into the next cell. `solid_edges` outline the closed components cut halfway between; those of one component join end to
/// start exactly. `floors` are the parts of triangles with z ≤ z_min that are less than 60° steep; each has an area. Throws
/// std::invalid_argument unless both heights are finite and in this order.
Slice slice(const std::vector<TriangleMesh>& meshes, double z_min, double z_max);

/// The same of a site that is known by points: `surfaces` are the points with z in [z_min, z_max], `floors` the parts of discs with
/// z ≤ z_min, their centers too, that are less than 60° steep. Points enclose nothing, so there are no `solid_edges`.
Slice slice(const DiscCloud& discs, double z_min, double z_max);

}  // namespace alignability
