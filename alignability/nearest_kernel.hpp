// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

/// The inner loops of the search for nearest points.
namespace alignability::detail {

struct RawBox {
  float low[3];
  float high[3];
};

/// Boxes as three lists of lowest and three of highest coordinates.
struct RawBoxes {
  const float* low[3];
  const float* high[3];
};

/// The same loops for the processor at hand. The results do not depend on which.
struct NearestKernel {
  /// Which of the sixteen children of each node are within a radius of a box. `near` has room for sixteen more than are found.
  int (*near_children)(const RawBoxes& boxes, const std::int32_t* nodes, int count, const RawBox& query, float radius2, std::int32_t* near);

  /// The squared distances of all points of some blocks to eight queries, whose x, y and z follow one another by eights: eight a point.
  void (*distances2)(const float* coordinates, const std::int32_t* blocks, int count, const float* queries, float* distances2);

  /// Of eight lists of distances, as `distances2` makes them, those up to a bound: bit b of word w of list i, at [8 w + i], stands for
  /// its element 32 w + b. The bounds are brought down to where exactly `wanted` are within, if equal or nearly equal ones do not
  /// prevent it; `found` says how many are. False where a bound holds fewer at the start. `count` is a whole number of 32.
  bool (*select)(const float* distances2, int count, int wanted, float* bounds, std::int32_t* found, std::uint32_t* bits);
};

/// The fastest that this processor can run.
const NearestKernel& nearest_kernel();
/// The one that every processor can.
const NearestKernel& portable_nearest_kernel();

}  // namespace alignability::detail
