// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/nearest_kernel.hpp"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include <array>

#include "alignability/lanes.hpp"

namespace alignability::detail {
namespace {

ALIGNABILITY_INLINE Floats above_zero(Floats values) { return values > 0.0f ? values : Floats{}; }

// Rounded alike in near_slots: no point is nearer than its box.
ALIGNABILITY_INLINE Floats box_distances2(const RawBoxes& boxes, int first, const RawBox& query) {
  Floats sum = {};
  for (int axis = 0; axis < 3; ++axis) {
    const Floats gap =
        above_zero(load(boxes.low[axis] + first) - query.high[axis]) + above_zero(query.low[axis] - load(boxes.high[axis] + first));
    sum += gap * gap;
  }
  return sum;
}

ALIGNABILITY_INLINE Floats point_distances2(const float* block, const float* point) {
  Floats sum = {};
  for (int axis = 0; axis < 3; ++axis) {
    const Floats difference = load(block + kLanes * axis) - point[axis];
    sum += difference * difference;
  }
  return sum;
}

ALIGNABILITY_INLINE void rank_all(const float* values, int count, std::int32_t* ranks) {
  constexpr Ints kLane = {0, 1, 2, 3, 4, 5, 6, 7};
  for (int i = 0; i < count; i += kLanes) {
    const Floats mine = load(values + i);
    Ints before = {};
    for (int j = 0; j < i; ++j) before -= values[j] <= mine;
    for (int j = 0; j < kLanes; ++j) before -= (values[i + j] < mine) | ((values[i + j] == mine) & (kLane > j));
    for (int j = i + kLanes; j < count; ++j) before -= values[j] < mine;
    store(ranks + i, before);
  }
}

int near_children(const RawBoxes& boxes, const std::int32_t* nodes, int count, const RawBox& query, float radius2, std::int32_t* near) {
  int found = 0;
  for (int half = 0; half < 2 * count; ++half) {
    const int first = kLanes * (2 * nodes[half / 2] + half % 2);
    const Ints is_near = box_distances2(boxes, first, query) <= radius2;
    for (int lane = 0; lane < kLanes; ++lane) {
      near[found] = first + lane;
      found -= is_near[lane];
    }
  }
  return found;
}

int near_slots(const float* coordinates, const std::int32_t* blocks, int count, const float* point, float radius2, std::int32_t* slots,
               float* distances2) {
  int found = 0;
  for (int b = 0; b < count; ++b) {
    const int first = kLanes * blocks[b];
    const Floats distance2 = point_distances2(coordinates + 3 * first, point);
    const Ints is_near = distance2 <= radius2;
    for (int lane = 0; lane < kLanes; ++lane) {
      slots[found] = first + lane;
      distances2[found] = distance2[lane];
      found -= is_near[lane];
    }
  }
  return found;
}

void rank(const float* values, int count, std::int32_t* ranks) { rank_all(values, count, ranks); }

#if defined(__x86_64__)

// For each set of lanes their numbers in order, the rest after them.
constexpr auto kPacked = [] {
  std::array<std::array<std::int32_t, kLanes>, 256> table{};
  for (unsigned set = 0; set < table.size(); ++set) {
    std::size_t next = 0;
    for (const bool wanted : {true, false}) {
      for (int lane = 0; lane < kLanes; ++lane) {
        if (((set >> lane & 1U) != 0U) == wanted) table[set][next++] = lane;
      }
    }
  }
  return table;
}();

ALIGNABILITY_AVX2 int near_children_avx2(const RawBoxes& boxes, const std::int32_t* nodes, int count, const RawBox& query, float radius2,
                                         std::int32_t* near) {
  int found = 0;
  for (int half = 0; half < 2 * count; ++half) {
    const int first = kLanes * (2 * nodes[half / 2] + half % 2);
    const auto set = static_cast<unsigned>(_mm256_movemask_ps((__m256)(box_distances2(boxes, first, query) <= radius2)));
    Ints packed;
    __builtin_memcpy(&packed, kPacked[set].data(), sizeof packed);
    store(near + found, packed + first);
    found += __builtin_popcount(set);
  }
  return found;
}

ALIGNABILITY_AVX2 int near_slots_avx2(const float* coordinates, const std::int32_t* blocks, int count, const float* point, float radius2,
                                      std::int32_t* slots, float* distances2) {
  int found = 0;
  for (int b = 0; b < count; ++b) {
    const int first = kLanes * blocks[b];
    const Floats distance2 = point_distances2(coordinates + 3 * first, point);
    const auto set = static_cast<unsigned>(_mm256_movemask_ps((__m256)(distance2 <= radius2)));
    Ints packed;
    __builtin_memcpy(&packed, kPacked[set].data(), sizeof packed);
    store(slots + found, packed + first);
    store(distances2 + found, (Floats)_mm256_permutevar8x32_ps((__m256)distance2, (__m256i)packed));
    found += __builtin_popcount(set);
  }
  return found;
}

ALIGNABILITY_AVX2 void rank_avx2(const float* values, int count, std::int32_t* ranks) { rank_all(values, count, ranks); }

#endif

}  // namespace

const NearestKernel& portable_nearest_kernel() {
  static constexpr NearestKernel kPortable{near_children, near_slots, rank};
  return kPortable;
}

const NearestKernel& nearest_kernel() {
#if defined(__x86_64__)
  static constexpr NearestKernel kAvx2{near_children_avx2, near_slots_avx2, rank_avx2};
  static const bool kHasAvx2 = __builtin_cpu_supports("avx2") != 0;
  if (kHasAvx2) return kAvx2;
#endif
  return portable_nearest_kernel();
}

}  // namespace alignability::detail
