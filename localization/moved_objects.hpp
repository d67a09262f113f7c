// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lidar/triangle_mesh.hpp"

namespace alignability {

struct MovedObjects {
  std::vector<TriangleMesh> meshes;  ///< the site, in the order given
  std::size_t movable = 0;           ///< those of a pallet's size
  std::size_t moved = 0;
};

/// A site in which a share, in [0,1], of the loose things stands elsewhere: meshes of at most 1.6 × 1.6 m and 2.2 m in height, as a pallet
/// with its load is, are shifted over the floor by 0.2 to 1 m in any direction. It is what a map may look like that is no longer true.
/// Things may end up in one another. The same seed moves the same things. Throws std::invalid_argument for a share out of range.
MovedObjects with_moved_objects(std::vector<TriangleMesh> meshes, double share, std::uint64_t seed);

}  // namespace alignability
