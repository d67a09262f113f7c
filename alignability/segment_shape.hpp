// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "lidar/scan.hpp"

namespace alignability::detail {

/// The points of each segment by their place in the scan; `segment_of_point` counts from 0, -1 = none.
std::vector<std::vector<std::int32_t>> members_of(const std::vector<int>& segment_of_point, int segments);

/// The principal axes of a segment's points, the narrowest first, and how the points spread along them [m]. Of a line of two dimensions
/// they are the one across it, the one along it, and z, along which it has no extent.
struct SegmentShape {
  Eigen::Vector3d center;
  Eigen::Matrix3d axes;         ///< by column; signs arbitrary
  Eigen::Vector3d eigenvalues;  ///< of the points' covariance, ascending but for a line's last, 0
  Eigen::Vector3d extents;      ///< of the oriented bounding box along the axes

  /// λ_s/λ_l; 0 for points that are all one.
  double flatness() const;
  /// The same of a line.
  double straightness() const;
  /// The two largest extents, multiplied.
  double area() const;
};

SegmentShape shape_of(const Scan& scan, std::span<const std::int32_t> members);

/// Of x and y alone.
SegmentShape line_shape_of(const Scan& scan, std::span<const std::int32_t> members);

}  // namespace alignability::detail
