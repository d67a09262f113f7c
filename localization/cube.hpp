// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <compare>
#include <cstddef>
#include <cstdint>

namespace alignability {

/// One of the cubes of a side that are stacked from the origin: the numbers of its lower corner.
struct Cube {
  std::int32_t x, y, z;
  auto operator<=>(const Cube&) const = default;
};

/// The cube that holds a finite place; those beyond 2^30 sides from the origin are one, so that a cube has neighbours all around.
inline Cube cube_of(const Eigen::Vector3d& place, double side) {
  constexpr double kFar = 1 << 30;
  const Eigen::Array3d cube = (place.array() / side).floor().max(-kFar).min(kFar);
  return {static_cast<std::int32_t>(cube.x()), static_cast<std::int32_t>(cube.y()), static_cast<std::int32_t>(cube.z())};
}

struct CubeHash {
  std::size_t operator()(const Cube& cube) const {
    const auto word = [](std::int32_t value) { return static_cast<std::uint64_t>(static_cast<std::uint32_t>(value)); };
    const std::uint64_t hash = word(cube.x) * 0x9e3779b97f4a7c15U ^ word(cube.y) * 0xc2b2ae3d27d4eb4fU ^ word(cube.z) * 0x165667b19e3779f9U;
    return hash ^ hash >> 29;
  }
};

}  // namespace alignability
