// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "alignability/nearest.hpp"
#include "alignability/plane_segmentation.hpp"
#include "alignability/point_blocks.hpp"
#include "alignability/region_growing.hpp"

namespace alignability::detail {

/// The native engine with its memory, which it keeps from scan to scan; `automatic` dimensions are three to it. One a thread.
class NativeSegmenter {
 public:
  /// The result is valid until the next call.
  const Segmentation& segment(const Scan& scan, const SegmentationOptions& options);

 private:
  /// Up to eight voters that lie near one another.
  struct Group {
    std::array<std::int32_t, NearestPoints::kQueries> slots;
    std::size_t size = 0;
    std::span<const std::int32_t> voters() const { return std::span(slots).first(size); }
  };

  void find_voters(const Scan& scan, int stride);
  void estimate(const Scan& scan, const SegmentationOptions& options);
  void finish(Group& group, const Scan& scan, const SegmentationOptions& options);
  void link(const Group& group);
  void take_normals(const Group& group, const Scan& scan, int neighbours);
  void take_line_normals(const Group& group, const Scan& scan);
  void set_normal(std::int32_t slot, const Scan& scan, Eigen::Vector3f normal, float curvature);

  PointBlocks blocks_;
  NearestPoints nearest_;
  NeighbourGraph graph_;
  RegionGrower grower_;
  Segmentation result_;
};

/// Whether a scan is one ring whose returns all lie in the lidar's xy plane; also where none came back.
bool lies_in_xy(const Scan& scan, double range_min);

/// By PCL, which knows neither a stride nor two dimensions.
Segmentation segment_with_pcl(const Scan& scan, const SegmentationOptions& options);

}  // namespace alignability::detail
