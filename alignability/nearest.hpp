// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "alignability/nearest_kernel.hpp"
#include "alignability/point_blocks.hpp"

namespace alignability::detail {

/// Finds the exact nearest points of eight points at once; of equally far ones those first in the list. One a thread: it keeps its memory,
/// and the radius that held the last points' neighbours, where the next search begins. The result does not depend on either.
///
/// Why the set is exact: all blocks with a box within R of the box around the eight are gathered, so that no point outside them is within
/// R of one of the eight. If R holds k gathered points of each, the k nearest are among these; else R grows.
class NearestPoints {
 public:
  static constexpr int kQueries = PointBlocks::kBlock;
  /// As many blocks share a word of `nearest()`.
  static constexpr int kBlocksOfWord = 32 / PointBlocks::kBlock;

  /// To be searched from now on; must outlive the searches.
  void assign(const PointBlocks& points);

  /// The `count` nearest of each of one to eight slots, the point itself among them; `count` is at most the points there are.
  void search(std::span<const std::int32_t> slots, int count);
  /// Of those found last only the `count` nearest; at most as many as `search` was asked for.
  void narrow(int count);

  /// The blocks around the points of the last search, a whole number of words of them; empty ones fill up.
  std::span<const std::int32_t> blocks() const { return std::span(blocks_).first(static_cast<std::size_t>(block_count_)); }
  /// Bit b of word w of point i, at [8 w + i], is set where slot b % 8 of `blocks()[4 w + b / 8]` is one of its nearest.
  std::span<const std::uint32_t> nearest() const {
    return std::span(bits_).first(static_cast<std::size_t>(block_count_ / kBlocksOfWord * kQueries));
  }
  /// The eight points' x, y and z, by eights; fewer than eight repeat the first.
  const std::array<float, 3 * kQueries>& queries() const { return queries_; }

 private:
  RawBox set_queries(std::span<const std::int32_t> slots);
  void gather_blocks(const RawBox& around);
  void drop_surplus(const std::array<std::int32_t, kQueries>& found, int count);
  void drop_farthest(int query, int count);

  struct Ranked {
    float distance2;
    std::uint32_t candidate;
    auto operator<=>(const Ranked&) const = default;
  };

  const PointBlocks* points_ = nullptr;
  float radius2_ = 1e-4f;
  std::array<float, 3 * kQueries> queries_{};
  std::array<float, kQueries> bounds_{};
  int block_count_ = 0;
  std::vector<std::int32_t> blocks_;
  std::vector<std::int32_t> nodes_;
  std::vector<float> distances2_;
  std::vector<std::uint32_t> bits_;
  std::vector<Ranked> ranked_;
};

}  // namespace alignability::detail
