// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace alignability::detail {

class PointBlocks;

/// Finds the exact nearest points; of equally far ones those first in the list. One a thread: it keeps its memory, and the radius that
/// held the last point's neighbours, where the next search begins. The result does not depend on either.
///
/// Why the set is exact: all blocks with a box within R of the box of the point's block are gathered, so that no point outside them is
/// within R of the point. If R holds k gathered points, the k nearest are among these; else R grows. Neighbouring points share a gathering.
class NearestPoints {
 public:
  /// To be searched from now on; must outlive the searches.
  void assign(const PointBlocks& points);

  /// The slots of the `count` nearest, the nearest first, the point itself among them; `count` is at most the points there are. Valid
  /// until the next call.
  std::span<const std::int32_t> search(int slot, int count);

 private:
  void gather_blocks(int block, float radius2);
  void gather_slots(int slot);
  void sort();
  float distance2(std::int32_t a, std::int32_t b) const;

  const PointBlocks* points_ = nullptr;
  float radius2_ = 1e-4f;
  int block_ = -1;           // whose surroundings are gathered,
  float gathered2_ = -1.0f;  // and how far
  int block_count_ = 0;
  std::vector<std::int32_t> blocks_;
  std::vector<std::int32_t> nodes_;
  int candidates_ = 0;
  std::vector<std::int32_t> slots_;
  std::vector<float> distances2_;
  std::vector<std::int32_t> ranks_;
  std::vector<std::int32_t> sorted_;
};

}  // namespace alignability::detail
