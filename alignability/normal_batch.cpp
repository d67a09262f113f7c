// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/normal_batch.hpp"

#include "alignability/normal_kernel.hpp"

namespace alignability::detail {

void NormalBatch::begin(int neighbours) {
  count_ = 0;
  relative_.assign(3 * kSize * static_cast<std::size_t>(neighbours), 0.0f);
}

bool NormalBatch::add(const PointBlocks& points, std::int32_t slot, std::span<const std::int32_t> neighbours) {
  const float* coordinates = points.coordinates().data();
  const float* center = coordinates + PointBlocks::place(slot);
  float* relative = relative_.data() + count_;
  for (const std::int32_t neighbour : neighbours) {
    const float* place = coordinates + PointBlocks::place(neighbour);
    for (std::size_t axis = 0; axis < 3; ++axis) relative[kSize * axis] = place[kSize * axis] - center[kSize * axis];
    relative += 3 * kSize;
  }
  estimates_[count_++].slot = slot;
  return count_ == kSize;
}

std::span<const NormalBatch::Estimate> NormalBatch::finish() {
  const std::size_t count = count_;
  count_ = 0;
  if (count == 0) return {};
  std::array<float, 3 * kSize> normals;
  std::array<float, kSize> curvatures;
  estimate_normals(relative_.data(), static_cast<int>(relative_.size() / (3 * kSize)), normals.data(), curvatures.data());
  for (std::size_t i = 0; i < count; ++i) {
    estimates_[i].normal = {normals[i], normals[kSize + i], normals[2 * kSize + i]};
    estimates_[i].curvature = curvatures[i];
  }
  return std::span(estimates_).first(count);
}

}  // namespace alignability::detail
