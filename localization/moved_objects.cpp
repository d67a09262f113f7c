// SPDX-License-Identifier: BSD-3-Clause
#include "localization/moved_objects.hpp"

#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

#include "core/range.hpp"

namespace alignability {
namespace {

constexpr float kWidest = 1.6f, kTallest = 2.2f;   // [m]
constexpr double kNearest = 0.2, kFarthest = 1.0;  // [m]

bool is_movable(const TriangleMesh& mesh) {
  const Eigen::AlignedBox3f box = bounds(mesh);
  if (box.isEmpty()) return false;
  const Eigen::Vector3f sizes = box.sizes();
  return sizes.x() <= kWidest && sizes.y() <= kWidest && sizes.z() <= kTallest;
}

double uniform(std::mt19937_64& engine) { return static_cast<double>(engine() >> 11) * 0x1p-53; }

}  // namespace

MovedObjects with_moved_objects(std::vector<TriangleMesh> meshes, double share, std::uint64_t seed) {
  if (!kShare.contains(share)) throw std::invalid_argument("the share of moved objects must be in [0, 1]");
  std::mt19937_64 engine(seed);
  MovedObjects site{.meshes = std::move(meshes)};
  for (TriangleMesh& mesh : site.meshes) {
    if (!is_movable(mesh)) continue;
    ++site.movable;
    const bool moves = uniform(engine) < share;
    const double angle = 2.0 * std::numbers::pi * uniform(engine);
    const double distance = kNearest + (kFarthest - kNearest) * uniform(engine);
    if (!moves) continue;
    ++site.moved;
    mesh = transformed(mesh, Eigen::Affine3d(Eigen::Translation3d(distance * std::cos(angle), distance * std::sin(angle), 0.0)));
  }
  return site;
}

}  // namespace alignability
