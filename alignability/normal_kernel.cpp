// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/normal_kernel.hpp"

#include <cfloat>

#include "alignability/lanes.hpp"

namespace alignability::detail {
namespace {

// Rotations converge quadratically: after four sweeps what is off the diagonal is below float's precision.
constexpr int kSweeps = 4;

// Of eight symmetric matrices the rows and columns p, q and the remaining r, and two of the axes found so far.
struct Rotation {
  Floats& pp;
  Floats& qq;
  Floats& pq;
  Floats& pr;
  Floats& qr;
  Floats* axis_p;
  Floats* axis_q;
};

ALIGNABILITY_INLINE void rotate(Rotation m) {
  const Floats apart = m.qq - m.pp;
  const Floats root = square_root(apart * apart + 4.0f * m.pq * m.pq) + FLT_MIN;
  const Floats tangent = 2.0f * m.pq / (apart + (apart < 0.0f ? -root : root));
  const Floats cosine = 1.0f / square_root(1.0f + tangent * tangent);
  const Floats sine = tangent * cosine;
  m.pp -= tangent * m.pq;
  m.qq += tangent * m.pq;
  m.pq = Floats{};
  const auto turn = [&](Floats & p, Floats & q) __attribute__((always_inline)) {
    const Floats before = p;
    p = cosine * p - sine * q;
    q = sine * before + cosine * q;
  };
  turn(m.pr, m.qr);
  for (int k = 0; k < 3; ++k) turn(m.axis_p[k], m.axis_q[k]);
}

// Of xx, xy, xz, yy, yz, zz.
ALIGNABILITY_INLINE void find_axes(Floats* m, float* normals, float* curvatures) {
  const Floats scale = 1.0f / (m[0] + m[3] + m[5] + FLT_MIN);
  for (int k = 0; k < 6; ++k) m[k] *= scale;
  Floats axes[3][3] = {};  // axis, coordinate
  for (int k = 0; k < 3; ++k) axes[k][k] += 1.0f;
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    rotate({m[0], m[3], m[1], m[2], m[4], axes[0], axes[1]});
    rotate({m[0], m[5], m[2], m[1], m[4], axes[0], axes[2]});
    rotate({m[3], m[5], m[4], m[1], m[2], axes[1], axes[2]});
  }
  const Ints y_first = m[3] < m[0];
  const Floats least_xy = y_first ? m[3] : m[0];
  const Ints z_first = m[5] < least_xy;
  const Floats least = z_first ? m[5] : least_xy;
  store(curvatures, least > 0.0f ? least : Floats{});
  for (int k = 0; k < 3; ++k) store(normals + kLanes * k, z_first ? axes[2][k] : (y_first ? axes[1][k] : axes[0][k]));
}

ALIGNABILITY_INLINE std::uint32_t united(const std::uint32_t* words) {
  std::uint32_t all = 0;
  for (int lane = 0; lane < kLanes; ++lane) all |= words[lane];
  return all;
}

ALIGNABILITY_INLINE void find_covariances(const EightNeighbourhoods& near, Floats* covariances) {
  const Floats center_x = load(near.centers);
  const Floats center_y = load(near.centers + kLanes);
  const Floats center_z = load(near.centers + 2 * kLanes);
  Floats x = {}, y = {}, z = {}, xx = {}, xy = {}, xz = {}, yy = {}, yz = {}, zz = {};
  const std::uint32_t* words = near.nearest.data();
  for (std::size_t block = 0; block < near.blocks.size(); block += 32 / kLanes, words += kLanes) {
    Ints nearest;
    __builtin_memcpy(&nearest, words, sizeof nearest);
    for (std::uint32_t left = united(words); left != 0; left &= left - 1) {
      const int bit = __builtin_ctz(left);
      const float* point = near.coordinates + 3 * kLanes * near.blocks[block + static_cast<unsigned>(bit / kLanes)] + bit % kLanes;
      const Ints counts = (nearest & static_cast<std::int32_t>(1U << bit)) != 0;
      const Floats px = counts ? point[0] - center_x : Floats{};
      const Floats py = counts ? point[kLanes] - center_y : Floats{};
      const Floats pz = counts ? point[2 * kLanes] - center_z : Floats{};
      x += px;
      y += py;
      z += pz;
      xx += px * px;
      xy += px * py;
      xz += px * pz;
      yy += py * py;
      yz += py * pz;
      zz += pz * pz;
    }
  }
  const float share = 1.0f / static_cast<float>(near.points);
  x *= share;
  y *= share;
  z *= share;
  covariances[0] = xx * share - x * x;
  covariances[1] = xy * share - x * y;
  covariances[2] = xz * share - x * z;
  covariances[3] = yy * share - y * y;
  covariances[4] = yz * share - y * z;
  covariances[5] = zz * share - z * z;
}

ALIGNABILITY_INLINE void estimate(const EightNeighbourhoods& near, float* normals, float* curvatures) {
  Floats covariances[6];
  find_covariances(near, covariances);
  find_axes(covariances, normals, curvatures);
}

using Estimate = void (*)(const EightNeighbourhoods&, float*, float*);

#if defined(__x86_64__)
ALIGNABILITY_AVX2 void estimate_avx2(const EightNeighbourhoods& near, float* normals, float* curvatures) {
  estimate(near, normals, curvatures);
}
#endif

Estimate fastest() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2") != 0) return estimate_avx2;
#endif
  return estimate_normals_portably;
}

}  // namespace

void estimate_normals_portably(const EightNeighbourhoods& near, float* normals, float* curvatures) { estimate(near, normals, curvatures); }

void estimate_normals(const EightNeighbourhoods& near, float* normals, float* curvatures) {
  static const Estimate kEstimate = fastest();
  kEstimate(near, normals, curvatures);
}

}  // namespace alignability::detail
