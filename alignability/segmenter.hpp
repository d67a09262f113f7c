// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "alignability/segmentation_engines.hpp"

namespace alignability::detail {

/// Segments scans by the engine asked for, keeping the memory of the native one. One a thread.
class Segmenter {
 public:
  /// Of several lidars each lidar's part on its own, in its own frame; the normals are in the frame of the scan. The result is valid until
  /// the next call.
  const Segmentation& segment(const Scan& scan, const SegmentationOptions& options);
  /// What `segment` returned last.
  const Segmentation& last() const { return *last_; }

 private:
  const Segmentation& segment_one(const Scan& scan, const SegmentationOptions& options);

  NativeSegmenter native_;
  Segmentation by_pcl_;
  Segmentation joined_;
  const Segmentation* last_ = &joined_;
};

/// What one lidar of several saw, in its own frame.
Scan own_scan(const Scan& scan, const ScanPart& part);

/// Two or three; of several lidars two where it is so for all.
Dimensions resolved_dimensions(const Scan& scan, const SegmentationOptions& options);

}  // namespace alignability::detail
