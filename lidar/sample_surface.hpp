// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lidar/point_cloud.hpp"
#include "lidar/triangle_mesh.hpp"

namespace alignability {

struct SampleOptions {
  double spacing = 0.05;  ///< [m] one point for each square of this side, on average; > 0
  double stddev = 0.0;    ///< of the points off their surface [m], >= 0
  std::uint64_t seed = 1;
};

/// Points spread evenly at random over all surfaces, as if a scanner had seen each from everywhere, and the normals of these surfaces.
/// What a scanner sees from no side is left out: what has something solid on both, and the floor beneath it, for nobody looks up from under
/// the lowest floor. Throws std::invalid_argument for options out of range and for more than 2^26 points.
PointCloud sample_surface(const std::vector<TriangleMesh>& meshes, const SampleOptions& options = {});

}  // namespace alignability
