// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <span>
#include <vector>

#include "lidar/disc_cloud.hpp"
#include "lidar/triangle_mesh.hpp"

namespace alignability {

/// A place where a sensor would be nearer to a surface [m] is none to scan from.
inline constexpr float kSensorClearance = 0.1f;

/// Surfaces in the `map` frame that rays can be traced against, by Intel Embree. Immutable; copies share their data; all queries may be
/// called from many threads at once.
class Scene {
 public:
  /// Throws `std::invalid_argument` when a triangle names a vertex that is not there, a vertex or disc is not finite, or a disc lacks its
  /// normal or radius, and `std::runtime_error` when Embree refuses (out of memory).
  explicit Scene(std::vector<TriangleMesh> meshes, DiscCloud discs = {});

  const std::vector<TriangleMesh>& meshes() const;
  const DiscCloud& discs() const;
  /// Empty when there are no surfaces.
  Eigen::AlignedBox3f bounds() const;

  /// Distance [m] from `origin` to the first surface along each unit vector of `directions`, from either side of the surface; NaN where
  /// there is none within `max_range`.
  std::vector<float> cast(const Eigen::Vector3f& origin, std::span<const Eigen::Vector3f> directions, float max_range) const;

  /// False inside something solid, that is where a vertical ray leaves closed components more often than it enters them, and nearer to a
  /// surface than `clearance` [m]. Discs enclose nothing.
  bool is_free(const Eigen::Vector3f& point, float clearance) const;

 private:
  struct Data;
  std::shared_ptr<const Data> data_;
};

}  // namespace alignability
