// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "alignability/point_blocks.hpp"

namespace alignability::detail {

/// Collects neighbourhoods until there are eight, whose normals cost as much as one's.
class NormalBatch {
 public:
  struct Estimate {
    std::int32_t slot;
    std::array<float, 3> normal;  ///< unit, sign arbitrary
    float curvature;              ///< λ_min over the trace of the covariance
  };

  /// Of neighbourhoods of so many points each.
  void begin(int neighbours);

  /// True when the batch is full and must be finished.
  bool add(const PointBlocks& points, std::int32_t slot, std::span<const std::int32_t> neighbours);

  /// The normals of those added since the last call; valid until the next.
  std::span<const Estimate> finish();

 private:
  static constexpr std::size_t kSize = PointBlocks::kBlock;

  std::size_t count_ = 0;
  std::array<Estimate, kSize> estimates_{};
  std::vector<float> relative_;
};

}  // namespace alignability::detail
