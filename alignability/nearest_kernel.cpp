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

// Rounded alike in find_distances2: no point is nearer than its box.
ALIGNABILITY_INLINE Floats box_distances2(const RawBoxes& boxes, int first, const RawBox& query) {
  Floats sum = {};
  for (int axis = 0; axis < 3; ++axis) {
    const Floats gap =
        above_zero(load(boxes.low[axis] + first) - query.high[axis]) + above_zero(query.low[axis] - load(boxes.high[axis] + first));
    sum += gap * gap;
  }
  return sum;
}

ALIGNABILITY_INLINE void find_distances2(const float* coordinates, const std::int32_t* blocks, int count, const float* queries,
                                         float* distances2) {
  const Floats x = load(queries);
  const Floats y = load(queries + kLanes);
  const Floats z = load(queries + 2 * kLanes);
  for (int b = 0; b < count; ++b) {
    const float* block = coordinates + 3 * kLanes * blocks[b];
    for (int slot = 0; slot < kLanes; ++slot, distances2 += kLanes) {
      const Floats dx = block[slot] - x;
      const Floats dy = block[kLanes + slot] - y;
      const Floats dz = block[2 * kLanes + slot] - z;
      store(distances2, dx * dx + dy * dy + dz * dz);
    }
  }
}

// Eight answers, as memory: clang hands no wide vector over between functions of different instruction sets, be they inlined.
struct NearBoxes {
  alignas(Ints) std::int32_t lanes[kLanes];  // -1 where near, else 0
};

ALIGNABILITY_INLINE NearBoxes near_boxes(const RawBoxes& boxes, int first, const RawBox& query, float radius2) {
  const Ints are_near = box_distances2(boxes, first, query) <= radius2;
  NearBoxes result;
  __builtin_memcpy(result.lanes, &are_near, sizeof are_near);
  return result;
}

// `count` is a whole number of eights.
ALIGNABILITY_INLINE Ints count_within(const float* distances2, int count, Floats bounds) {
  Ints counts[4] = {};
  for (const float* end = distances2 + kLanes * count; distances2 != end; distances2 += 8 * kLanes) {
    for (int i = 0; i < 8; ++i) counts[i % 4] -= load(distances2 + kLanes * i) <= bounds;
  }
  return (counts[0] + counts[1]) + (counts[2] + counts[3]);
}

ALIGNABILITY_INLINE bool any(Ints lanes) {
  std::uint64_t pairs[kLanes / 2];
  __builtin_memcpy(pairs, &lanes, sizeof lanes);
  return (pairs[0] | pairs[1] | pairs[2] | pairs[3]) != 0;
}

// Of 32 candidates those within the bounds, the first in the lowest bit.
ALIGNABILITY_INLINE Ints bits_within(const float* distances2, Floats bounds) {
  using Words = std::uint32_t __attribute__((vector_size(4 * kLanes)));
  Words words = {};
#pragma GCC unroll 8
  for (int i = 0; i < 32; ++i) words = words >> 1 | ((Words)(load(distances2 + kLanes * i) <= bounds) & 0x80000000U);
  return (Ints)words;
}

// Points on a surface lie within a squared distance in proportion to it, so bounds are sought by interpolation; by halves in turn, for
// where they do not.
ALIGNABILITY_INLINE bool select_all(const float* distances2, int count, int wanted, float* bounds, std::int32_t* found,
                                    std::uint32_t* bits) {
  constexpr int kPasses = 10;
  Floats low = {};
  Ints within_low = {};
  Floats high = load(bounds);
  Ints within_high = count_within(distances2, count, high);
  if (any(within_high < wanted)) return false;
  for (int pass = 0; pass < kPasses && any(within_high != wanted); ++pass) {
    const Floats share =
        pass % 2 == 0 ? __builtin_convertvector(wanted - within_low, Floats) / __builtin_convertvector(within_high - within_low, Floats)
                      : Floats{} + 0.5f;
    const Floats middle = low + share * (high - low);
    const Ints within = count_within(distances2, count, middle);
    const Ints enough = within >= wanted;
    high = enough ? middle : high;
    within_high = enough ? within : within_high;
    low = enough ? low : middle;
    within_low = enough ? within_low : within;
  }
  store(bounds, high);
  store(found, within_high);
  for (int first = 0; first < count; first += 32, bits += kLanes) {
    const Ints words = bits_within(distances2 + kLanes * first, high);
    __builtin_memcpy(bits, &words, sizeof words);
  }
  return true;
}

int near_children(const RawBoxes& boxes, const std::int32_t* nodes, int count, const RawBox& query, float radius2, std::int32_t* near) {
  int found = 0;
  for (int half = 0; half < 2 * count; ++half) {
    const int first = kLanes * (2 * nodes[half / 2] + half % 2);
    const NearBoxes are_near = near_boxes(boxes, first, query, radius2);
    for (int lane = 0; lane < kLanes; ++lane) {
      near[found] = first + lane;
      found -= are_near.lanes[lane];
    }
  }
  return found;
}

void distances2(const float* coordinates, const std::int32_t* blocks, int count, const float* queries, float* to) {
  find_distances2(coordinates, blocks, count, queries, to);
}

bool select(const float* distances2, int count, int wanted, float* bounds, std::int32_t* found, std::uint32_t* bits) {
  return select_all(distances2, count, wanted, bounds, found, bits);
}

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
    const NearBoxes are_near = near_boxes(boxes, first, query, radius2);
    __m256 lanes;
    __builtin_memcpy(&lanes, are_near.lanes, sizeof lanes);
    const auto set = static_cast<unsigned>(_mm256_movemask_ps(lanes));
    Ints packed;
    __builtin_memcpy(&packed, kPacked[set].data(), sizeof packed);
    packed += first;
    __builtin_memcpy(near + found, &packed, sizeof packed);
    found += __builtin_popcount(set);
  }
  return found;
}

ALIGNABILITY_AVX2 void distances2_avx2(const float* coordinates, const std::int32_t* blocks, int count, const float* queries, float* to) {
  find_distances2(coordinates, blocks, count, queries, to);
}

ALIGNABILITY_AVX2 bool select_avx2(const float* distances2, int count, int wanted, float* bounds, std::int32_t* found,
                                   std::uint32_t* bits) {
  return select_all(distances2, count, wanted, bounds, found, bits);
}

#endif

}  // namespace

const NearestKernel& portable_nearest_kernel() {
  static constexpr NearestKernel kPortable{near_children, distances2, select};
  return kPortable;
}

const NearestKernel& nearest_kernel() {
#if defined(__x86_64__)
  static constexpr NearestKernel kAvx2{near_children_avx2, distances2_avx2, select_avx2};
  static const bool kHasAvx2 = __builtin_cpu_supports("avx2") != 0;
  if (kHasAvx2) return kAvx2;
#endif
  return portable_nearest_kernel();
}

}  // namespace alignability::detail
