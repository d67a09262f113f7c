// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/region_growing.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

namespace alignability::detail {
namespace {

constexpr std::int32_t kBlock = 8;
constexpr std::size_t kBlocksOfWord = 4;
constexpr std::size_t kLanes = 8;

}  // namespace

void RegionGrower::grow(const NeighbourGraph& graph, const GrowingOptions& options) {
  members_.clear();
  ends_.clear();
  free_ = graph.points;
  sort_seeds(graph);
  for (const std::uint64_t key : seeds_) {
    const auto seed = static_cast<std::int32_t>(key & 0xffffffffU);
    const std::size_t begin = members_.size();
    if (!take(seed)) continue;
    grow_from(seed, graph, options);
    if (members_.size() - begin < static_cast<std::size_t>(options.min_points)) {
      members_.resize(begin);
    } else {
      ends_.push_back(members_.size());
    }
  }
}

// The bits of floats that are not negative are in their order; those of the place behind make every key another. By counting on the
// upper bits first, since curvatures lie all over their range; in memory that is kept.
void RegionGrower::sort_seeds(const NeighbourGraph& graph) {
  seeds_.clear();
  for (std::size_t block = 0; block < graph.points.size(); ++block) {
    for (unsigned points = graph.points[block]; points != 0; points &= points - 1) {
      const std::size_t slot = block * kBlock + static_cast<std::size_t>(std::countr_zero(points));
      seeds_.push_back(std::uint64_t{std::bit_cast<std::uint32_t>(graph.normals[slot].curvature)} << 32 | slot);
    }
  }
  constexpr int kLowerBits = 48;
  bucket_ends_.assign((std::size_t{1} << (64 - kLowerBits)) + 1, 0);
  for (const std::uint64_t key : seeds_) ++bucket_ends_[(key >> kLowerBits) + 1];
  std::partial_sum(bucket_ends_.begin(), bucket_ends_.end(), bucket_ends_.begin());
  bucketed_.resize(seeds_.size());
  for (const std::uint64_t key : seeds_) bucketed_[bucket_ends_[key >> kLowerBits]++] = key;  // moves each beginning to its end
  seeds_.swap(bucketed_);
  std::uint32_t begin = 0;
  for (const std::uint32_t end : bucket_ends_) {
    if (end - begin > 1) std::sort(seeds_.begin() + begin, seeds_.begin() + end);
    begin = end;
  }
}

// False where a segment has it.
bool RegionGrower::take(std::int32_t slot) {
  std::uint8_t& free = free_[static_cast<std::size_t>(slot / kBlock)];
  const auto bit = static_cast<std::uint8_t>(1U << slot % kBlock);
  if ((free & bit) == 0) return false;
  free = static_cast<std::uint8_t>(free & ~bit);
  members_.push_back(slot);
  return true;
}

void RegionGrower::grow_from(std::int32_t seed, const NeighbourGraph& graph, const GrowingOptions& options) {
  for (std::size_t next = members_.size() - 1; next < members_.size(); ++next) {
    const auto i = static_cast<std::size_t>(members_[next]);
    const SurfaceNormal& from = graph.normals[i];
    if (from.curvature > options.curvature && members_[next] != seed) continue;
    const NeighbourGraph::Links& links = graph.links[i];
    for (std::size_t word = links.word; word < links.word + links.words; ++word) {
      const std::int32_t* blocks = graph.blocks.data() + kBlocksOfWord * word;
      const auto free = [&](std::size_t k) { return static_cast<std::uint32_t>(free_[static_cast<std::size_t>(blocks[k])]) << 8 * k; };
      std::uint32_t drawn = graph.bits[kLanes * word + links.lane] & (free(0) | free(1) | free(2) | free(3));
      for (; drawn != 0; drawn &= drawn - 1) {
        const int bit = std::countr_zero(drawn);
        const std::int32_t slot = kBlock * blocks[bit / kBlock] + bit % kBlock;
        const SurfaceNormal& normal = graph.normals[static_cast<std::size_t>(slot)];
        if (std::abs(normal.x * from.x + normal.y * from.y + normal.z * from.z) >= options.cosine) take(slot);
      }
    }
  }
}

}  // namespace alignability::detail
