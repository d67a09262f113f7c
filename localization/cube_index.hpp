// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace alignability {

/// One of the cubes of a side that are stacked from the origin: the numbers of its lower corner.
struct Cube {
  std::int32_t x, y, z;
  auto operator<=>(const Cube&) const = default;
};

/// The cube that holds a finite place; those beyond 2^30 sides from the origin are one, so that a cube has neighbours all around.
Cube cube_of(const Eigen::Vector3d& place, double side);

/// Numbers cubes in the order in which they come. A hash with open addresses: faster than std::unordered_map, which divides by a prime.
class CubeIndex {
 public:
  /// The number of a cube: the next one for a cube that is new.
  std::size_t number(const Cube& cube);
  std::optional<std::size_t> find(const Cube& cube) const {
    const std::int32_t number = slots_[slot_of(cube)].number;
    return number == kNone ? std::nullopt : std::optional(static_cast<std::size_t>(number));
  }

 private:
  static constexpr std::int32_t kNone = -1;
  struct Slot {
    Cube cube{};
    std::int32_t number = kNone;
  };

  // That of the cube, or the empty one for it: less than half are taken.
  std::size_t slot_of(const Cube& cube) const {
    const auto word = [](std::int32_t value) { return static_cast<std::uint64_t>(static_cast<std::uint32_t>(value)); };
    std::uint64_t hash = word(cube.x) * 0x9e3779b97f4a7c15U ^ word(cube.y) * 0xc2b2ae3d27d4eb4fU ^ word(cube.z) * 0x165667b19e3779f9U;
    hash ^= hash >> 29;
    std::size_t slot = hash & (slots_.size() - 1);
    while (slots_[slot].number != kNone && slots_[slot].cube != cube) slot = (slot + 1) & (slots_.size() - 1);
    return slot;
  }
  void grow();

  std::vector<Slot> slots_ = std::vector<Slot>(64);  // a power of two
  std::int32_t size_ = 0;
};

}  // namespace alignability
