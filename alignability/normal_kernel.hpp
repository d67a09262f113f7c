// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>

namespace alignability::detail {

/// Eight points and the points near each, as NearestPoints finds them.
struct EightNeighbourhoods {
  const float* coordinates;                ///< of all points, as PointBlocks has them
  const float* centers;                    ///< of the eight: x, y and z by eights
  std::span<const std::int32_t> blocks;    ///< four a word
  std::span<const std::uint32_t> nearest;  ///< bit b of word w of point i is at [8 w + i]
  int points;                              ///< near each
};

/// Their normals: the narrowest axes of the neighbourhoods' covariances, by Jacobi's rotations. `normals`: x, y and z, eight of each, unit,
/// signs arbitrary. `curvatures`: λ_min over the trace, in [0,1/3]. The result does not depend on the processor.
void estimate_normals(const EightNeighbourhoods& neighbourhoods, float* normals, float* curvatures);
/// The same by what every processor can.
void estimate_normals_portably(const EightNeighbourhoods& neighbourhoods, float* normals, float* curvatures);

}  // namespace alignability::detail
