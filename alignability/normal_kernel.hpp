// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace alignability::detail {

/// The normals of eight neighbourhoods at once: the narrowest axes of their covariances, by Jacobi's rotations. Point p of neighbourhood i
/// has its x at [24 p + i], y eight and z sixteen after it, relative to a place near by. `normals`: x, y and z, eight of each, unit, signs
/// arbitrary. `curvatures`: λ_min over the trace, in [0,1/3].
void estimate_normals(const float* neighbourhoods, int points, float* normals, float* curvatures);

}  // namespace alignability::detail
