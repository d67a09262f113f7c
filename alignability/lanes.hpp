// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

/// Eight floats in one: GCC's and Clang's vector types, which become AVX2 in functions that ask for it and pairs of SSE or NEON registers
/// elsewhere. A file that sees Eigen's types must not be compiled for AVX2 as a whole.
namespace alignability::detail {

inline constexpr int kLanes = 8;

using Floats = float __attribute__((vector_size(4 * kLanes)));
using Ints = std::int32_t __attribute__((vector_size(4 * kLanes)));

/// For functions that pass lanes: inlined into each caller, they are compiled for what the caller is.
#define ALIGNABILITY_INLINE inline __attribute__((always_inline))

#if defined(__x86_64__)
#define ALIGNABILITY_AVX2 __attribute__((target("avx2,popcnt")))
#endif

ALIGNABILITY_INLINE Floats load(const float* values) {
  Floats loaded;
  __builtin_memcpy(&loaded, values, sizeof loaded);
  return loaded;
}

ALIGNABILITY_INLINE void store(float* values, Floats lanes) { __builtin_memcpy(values, &lanes, sizeof lanes); }
ALIGNABILITY_INLINE void store(std::int32_t* values, Ints lanes) { __builtin_memcpy(values, &lanes, sizeof lanes); }

ALIGNABILITY_INLINE Floats square_root(Floats lanes) {
  for (int lane = 0; lane < kLanes; ++lane) lanes[lane] = __builtin_sqrtf(lanes[lane]);
  return lanes;
}

}  // namespace alignability::detail
