// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/pose.hpp"
#include "lidar/lidar_model.hpp"

namespace alignability::test {

/// Sixteen rings of 360 beams, 5 mm of noise, where base_link is.
inline LidarModel coarse_lidar() {
  LidarModel lidar;
  for (int ring = 0; ring < 16; ++ring) lidar.elevations.push_back(radians(-40.0 + 5.0 * ring));
  lidar.sectors = {{.min = radians(-180), .max = radians(180), .columns = 360}};
  lidar.range_min = 0.1;
  lidar.range_max = 20.0;
  lidar.range_stddev = 0.005;
  return lidar;
}

}  // namespace alignability::test
