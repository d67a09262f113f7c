// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "alignability/plane_segmentation.hpp"
#include "alignability/segment_shape.hpp"
#include "lidar/scan.hpp"

namespace alignability::detail {

/// What a scan saw of one plane, or line in two dimensions: segments that lie in it to within 30° and 5 cm, apart from one another for
/// whatever reason. In the frame of the scan.
struct MergedPlane {
  std::vector<std::int32_t> members;     ///< places in the scan
  std::vector<Eigen::Vector3d> normals;  ///< of the members that have one
  SegmentShape shape;
  /// The plane's own, from which noise makes the normals of its points lean: unit, towards the sensor. It is the narrowest axis of the
  /// points; where they are hardly wider than noise, the principal axis of their normals.
  Eigen::Vector3d own_normal;
  Eigen::Vector3d viewpoint;  ///< from where its first point was seen
  /// Noise alone could make it as wide as it is: points of one ring, whose normal is anybody's guess.
  bool is_strip = false;
  int segments = 1;

  double count() const { return static_cast<double>(normals.size()); }
};

/// The largest segments first, each takes in those that lie in its plane. By normals, the most first. `range_stddev` is the lidar's noise
/// [m]; `normals` are the points'. O(points + segments²).
std::vector<MergedPlane> merged_planes(const Scan& scan, std::vector<std::vector<std::int32_t>> segments,
                                       std::span<const Eigen::Vector3f> normals, Dimensions dimensions, double range_stddev);

}  // namespace alignability::detail
