// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

namespace alignability {

/// One lidar's share of a scan that several took together.
struct ScanPart {
  std::size_t begin = 0;  ///< its first point; rings * columns of them, ring-major
  int rings = 1;
  int columns = 0;
  /// Where the lidar sits in the frame of the scan.
  Eigen::Isometry3d T_scan_lidar = Eigen::Isometry3d::Identity();

  std::size_t size() const { return static_cast<std::size_t>(rings) * static_cast<std::size_t>(columns); }
};

/// What a robot's lidars saw in one turn [m]: points in the `lidar` frame where there is one, in `base_link` where there are several. A
/// beam without a return is NaN in all three coordinates. `points.size() == rings * columns`; where `organized()` the point of (ring,
/// column) has the index `ring * columns + column`.
struct Scan {
  std::vector<Eigen::Vector3f> points;
  int rings = 1;
  int columns = 0;
  /// Of several lidars, one after the other, the whole being one row; empty for one.
  std::vector<ScanPart> parts = {};

  /// Whether neighbours in the list are neighbours on the sensor. A scan of one ring counts as not organized.
  bool organized() const { return rings > 1; }
};

/// From where a point was seen, in the frame of the scan. O(parts).
Eigen::Vector3d viewpoint(const Scan& scan, std::size_t point);

}  // namespace alignability
