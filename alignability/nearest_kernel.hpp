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

/// The same three loops for the processor at hand. The results do not depend on which.
struct NearestKernel {
  /// Which of the sixteen children of each node are within a radius of a box. `near` has room for sixteen more than are found.
  int (*near_children)(const RawBoxes& boxes, const std::int32_t* nodes, int count, const RawBox& query, float radius2, std::int32_t* near);

  /// The slots within a radius of a point, and their squared distances; block after block `coordinates` has eight x, eight y and eight z.
  /// Both lists have room for eight more than are found.
  int (*near_slots)(const float* coordinates, const std::int32_t* blocks, int count, const float* point, float radius2, std::int32_t* slots,
                    float* distances2);

  /// The place of each value in ascending order, of equal ones the first first. `count` is a whole number of eights.
  void (*rank)(const float* values, int count, std::int32_t* ranks);
};

/// The fastest that this processor can run.
const NearestKernel& nearest_kernel();
/// The one that every processor can.
const NearestKernel& portable_nearest_kernel();

}  // namespace alignability::detail
