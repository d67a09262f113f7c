// SPDX-License-Identifier: BSD-3-Clause
#include "localization/cube_index.hpp"

#include <algorithm>
#include <utility>

namespace alignability {

namespace {

constexpr double kFar = 1 << 30;

}  // namespace

Cube cube_of(const Eigen::Vector3d& place, double side) {
  // As std::floor, which without SSE 4.1 is a call.
  const auto floored = [](double value) {
    const double inside = std::clamp(value, -kFar, kFar);
    const auto whole = static_cast<std::int32_t>(inside);
    return whole - (inside < whole ? 1 : 0);
  };
  return {floored(place.x() / side), floored(place.y() / side), floored(place.z() / side)};
}

std::size_t CubeIndex::number(const Cube& cube) {
  Slot& slot = slots_[slot_of(cube)];
  if (slot.number != kNone) return static_cast<std::size_t>(slot.number);
  const std::int32_t fresh = size_++;
  slot = {cube, fresh};
  if (2 * static_cast<std::size_t>(size_) >= slots_.size()) grow();
  return static_cast<std::size_t>(fresh);
}

void CubeIndex::grow() {
  std::vector<Slot> old(4 * slots_.size());
  std::swap(old, slots_);
  for (const Slot& slot : old) {
    if (slot.number != kNone) slots_[slot_of(slot.cube)] = slot;
  }
}

}  // namespace alignability
