// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace alignability {

/// Points on the surfaces of a site [m], and the normals of these surfaces, to either side and of any length: one a point, or none at all.
/// A normal that is zero or NaN is not known.
struct PointCloud {
  std::vector<Eigen::Vector3f> points;
  std::vector<Eigen::Vector3f> normals;
};

}  // namespace alignability
