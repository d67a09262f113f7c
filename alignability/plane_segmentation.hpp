// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/pose.hpp"
#include "lidar/scan.hpp"

namespace alignability {

/// How a scan is cut into smooth segments: normals, then region growing (Rabbani et al. 2006), with the numbers of Nobili et al. where
/// the paper gives none.
struct SegmentationOptions {
  double range_min = 0.5;          ///< [m] nearer returns are dropped
  int normal_neighbours = 30;      ///< >= 3
  int growing_neighbours = 15;     ///< >= 1
  double smoothness = radians(3);  ///< [rad] largest angle between the normals of a point and its neighbour
  double curvature = 1.0;          ///< a point above it grows no further
  int min_points = 50;             ///< a smaller segment is none
};

struct Segmentation {
  std::vector<Eigen::Vector3f> normals;  ///< unit, turned to the sensor; NaN for a point that was dropped
  std::vector<int> segment_of_point;     ///< counted from 0; -1 = none
  int segments = 0;
  std::size_t points = 0;  ///< those that were not dropped
};

/// By PCL's NormalEstimation and RegionGrowing: the reference for faster engines. NaN and near returns are dropped first.
Segmentation segment_with_pcl(const Scan& scan, const SegmentationOptions& options);

}  // namespace alignability
