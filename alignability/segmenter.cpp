// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/segmenter.hpp"

#include <algorithm>
#include <limits>

namespace alignability::detail {
namespace {

Segmentation with(Segmentation whole, const Segmentation& own, const ScanPart& part) {
  const Eigen::Matrix3f turned = part.T_scan_lidar.linear().cast<float>();
  for (std::size_t i = 0; i < own.normals.size(); ++i) whole.normals[part.begin + i] = turned * own.normals[i];
  const std::size_t before = whole.members.size();
  for (const std::int32_t member : own.members) whole.members.push_back(static_cast<std::int32_t>(part.begin) + member);
  for (const std::size_t end : own.ends) whole.ends.push_back(before + end);
  whole.points += own.points;
  return whole;
}

}  // namespace

const Segmentation& Segmenter::segment(const Scan& scan, const SegmentationOptions& options) {
  SegmentationOptions resolved = options;
  resolved.dimensions = resolved_dimensions(scan, options);
  if (scan.parts.empty()) {
    last_ = &segment_one(scan, resolved);
    return *last_;
  }
  Segmentation whole;
  whole.normals.assign(scan.points.size(), Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()));
  for (const ScanPart& part : scan.parts) whole = with(std::move(whole), segment_one(own_scan(scan, part), resolved), part);
  joined_ = std::move(whole);
  last_ = &joined_;
  return joined_;
}

const Segmentation& Segmenter::segment_one(const Scan& scan, const SegmentationOptions& options) {
  if (options.engine == Engine::native) return native_.segment(scan, options);
  by_pcl_ = segment_with_pcl(scan, options);
  return by_pcl_;
}

Scan own_scan(const Scan& scan, const ScanPart& part) {
  const Eigen::Isometry3f T_lidar_scan = part.T_scan_lidar.inverse().cast<float>();
  Scan own{.points = {}, .rings = part.rings, .columns = part.columns};
  own.points.reserve(part.size());
  for (std::size_t i = part.begin; i < part.begin + part.size(); ++i) own.points.emplace_back(T_lidar_scan * scan.points[i]);
  return own;
}

Dimensions resolved_dimensions(const Scan& scan, const SegmentationOptions& options) {
  if (options.dimensions != Dimensions::automatic) return options.dimensions;
  if (options.engine == Engine::pcl) return Dimensions::three;
  const bool flat = scan.parts.empty() ? lies_in_xy(scan, options.range_min) : std::ranges::all_of(scan.parts, [&](const ScanPart& part) {
    return lies_in_xy(own_scan(scan, part), options.range_min);
  });
  return flat ? Dimensions::two : Dimensions::three;
}

}  // namespace alignability::detail
