// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <vector>

#include "lidar/point_cloud.hpp"

namespace alignability {

/// Surfaces known by points alone: on each a disc that lies in the surface, in `map` [m].
struct DiscCloud {
  std::vector<Eigen::Vector3f> centers;
  std::vector<Eigen::Vector3f> normals;  ///< unit, to either side
  std::vector<float> radii;

  std::size_t size() const { return centers.size(); }
  bool empty() const { return centers.empty(); }
};

/// How points become discs; docs/design.md says how the numbers were found.
struct DiscOptions {
  std::optional<double> thinning = {};  ///< side of the cubes [m] of which each keeps one point, their mean; all points without
  int neighbours = 12;                  ///< of a point, itself not among them, >= 4: its normal and the spacing are taken from them
  double overlap = 0.8;                 ///< the radius, in distances to the farthest of `spacing_neighbours`; > 0
  int spacing_neighbours = 8;           ///< from 1 to `neighbours`
  double most_spacings = 4.0;           ///< no radius is larger than this many times the median one: a stray point is no wall; >= 1
};

/// A disc on each point that is finite and no repetition. The normals of a file are kept where they are there, unless points are thinned;
/// else a normal is the narrowest axis of the neighbours (PCL), at an edge that of the flattest neighbourhood that the point lies in. The
/// same discs for any number of threads. O(n log n). Throws std::invalid_argument for options out of range, and for fewer different points
/// than `neighbours` + 1.
DiscCloud discs_of(const PointCloud& cloud, const DiscOptions& options = {});

/// Of the disc with a number.
Eigen::AlignedBox3f bounds(const DiscCloud& discs, std::size_t disc);

/// Of all; empty when there are no discs.
Eigen::AlignedBox3f bounds(const DiscCloud& discs);

/// The median radius [m]; NaN when there are no discs.
float median_radius(const DiscCloud& discs);

}  // namespace alignability
