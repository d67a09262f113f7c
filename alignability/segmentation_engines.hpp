// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "alignability/nearest.hpp"
#include "alignability/normal_batch.hpp"
#include "alignability/plane_segmentation.hpp"
#include "alignability/point_blocks.hpp"
#include "alignability/region_growing.hpp"

namespace alignability::detail {

/// The native engine with its memory, which it keeps from scan to scan. One a thread.
class NativeSegmenter {
 public:
  /// The result is valid until the next call.
  const Segmentation& segment(const Scan& scan, const SegmentationOptions& options);

 private:
  void estimate(const Scan& scan, const SegmentationOptions& options);
  void number_voters(const Scan& scan, int stride);
  void link(std::size_t voter, std::span<const std::int32_t> nearest);
  void take_normals(const Scan& scan);

  PointBlocks blocks_;
  NearestPoints nearest_;
  NormalBatch batch_;
  std::vector<std::int32_t> slot_of_voter_;
  std::vector<std::int32_t> voter_of_slot_;  // -1 = none
  NeighbourGraph graph_;
  RegionGrower grower_;
  Segmentation result_;
};

/// By PCL, which knows no stride.
Segmentation segment_with_pcl(const Scan& scan, const SegmentationOptions& options);

}  // namespace alignability::detail
