// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "lidar/scan.hpp"

namespace alignability::test {

/// Adds `side` × `side` points 5 cm apart on a square around `center`, spanned by two unit vectors.
inline void add_patch(Scan& scan, const Eigen::Vector3f& center, const Eigen::Vector3f& u, const Eigen::Vector3f& v, int side = 20) {
  constexpr float kSpacing = 0.05f;
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) {
      scan.points.push_back(center + kSpacing * (static_cast<float>(i) - 0.5f * static_cast<float>(side - 1)) * u +
                            kSpacing * (static_cast<float>(j) - 0.5f * static_cast<float>(side - 1)) * v);
    }
  }
  scan.columns = static_cast<int>(scan.points.size());
}

/// Three patches of equal counts, apart from one another, one across each axis.
inline Scan three_walls(int side = 20) {
  const Eigen::Vector3f x = Eigen::Vector3f::UnitX(), y = Eigen::Vector3f::UnitY(), z = Eigen::Vector3f::UnitZ();
  Scan scan;
  add_patch(scan, 4.0f * x, y, z, side);
  add_patch(scan, 4.0f * y, z, x, side);
  add_patch(scan, -3.0f * z, x, y, side);
  return scan;
}

}  // namespace alignability::test
