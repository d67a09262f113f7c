// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/scan.hpp"

#include <algorithm>

namespace alignability {

Eigen::Vector3d viewpoint(const Scan& scan, std::size_t point) {
  const auto after = std::ranges::upper_bound(scan.parts, point, {}, &ScanPart::begin);
  return after == scan.parts.begin() ? Eigen::Vector3d::Zero() : Eigen::Vector3d(std::prev(after)->T_scan_lidar.translation());
}

}  // namespace alignability
