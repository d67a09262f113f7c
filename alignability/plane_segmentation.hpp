// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "core/pose.hpp"
#include "lidar/scan.hpp"

namespace alignability {

/// Who segments. Both search the same neighbours and grow the same segments; docs/design.md says how far the results differ.
enum class Engine {
  native,  ///< our own, many times as fast
  pcl,     ///< NormalEstimation and RegionGrowing of the Point Cloud Library, the reference
};

inline constexpr int kMostStride = 4;

/// What a scan is of: surfaces in space, or the lines in which a level ring meets upright ones.
enum class Dimensions {
  automatic,  ///< two where the scan is one ring whose returns all lie in the lidar's xy plane, else three; three with PCL
  two,
  three,
};

/// How a scan is cut into smooth segments: normals, then region growing (Rabbani et al. 2006), with the numbers of Nobili et al. where
/// the paper gives none.
struct SegmentationOptions {
  double range_min = 0.5;          ///< [m] nearer returns are dropped
  int normal_neighbours = 30;      ///< >= 3
  int growing_neighbours = 15;     ///< >= 1
  double smoothness = radians(3);  ///< [rad] largest angle between the normals of a point and its neighbour
  double curvature = 1.0;          ///< a point above it grows no further
  int min_points = 50;             ///< a smaller segment is none
  int min_line_points = 10;        ///< likewise in two dimensions
  /// Normals and votes of every n-th column alone, neighbours among all points; a scan without order has no columns, and all its points
  /// vote. Segments then grow over those neighbours that vote, at most √n · `smoothness` apart, and `min_points` counts the columns
  /// between. 1 to kMostStride: the growing neighbours of a point would hold no voters beyond.
  int stride = 1;
  Engine engine = Engine::native;
  /// In two dimensions x and y alone count: the normals are those of lines, and level.
  Dimensions dimensions = Dimensions::automatic;
};

struct Segmentation {
  std::vector<Eigen::Vector3f>
      normals;  ///< of each point of the scan: unit, turned to the sensor; NaN for a point that was dropped or passed over
  std::vector<std::int32_t> members;  ///< places in the scan, segment after segment
  std::vector<std::size_t> ends;      ///< of each segment in `members`
  std::size_t points = 0;             ///< those that were not dropped

  std::size_t segments() const { return ends.size(); }
  std::span<const std::int32_t> segment(std::size_t i) const {
    const std::size_t begin = i == 0 ? 0 : ends[i - 1];
    return std::span(members).subspan(begin, ends[i] - begin);
  }
};

}  // namespace alignability
