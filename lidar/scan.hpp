// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace alignability {

/// What a lidar saw in one turn: points in the `lidar` frame [m]. A beam without a return is NaN in all three coordinates.
/// `points.size() == rings * columns`; where `organized()` the point of (ring, column) has the index `ring * columns + column`.
struct Scan {
  std::vector<Eigen::Vector3f> points;
  int rings = 1;
  int columns = 0;

  /// Whether neighbours in the list are neighbours on the sensor. A scan of one ring counts as not organized.
  bool organized() const { return rings > 1; }
};

}  // namespace alignability
