// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/nearest.hpp"

#include <algorithm>
#include <bit>

namespace alignability::detail {
namespace {

constexpr float kLeastRadius2 = 1e-12f;
constexpr float kMostRadius2 = 1e37f;  // holds every point, and not the empty slots
// Neighbouring points' radii differ: what holds the next eight's neighbours as a rule.
constexpr float kRadiusMargin = 1.2f;
constexpr float kWidening = 2.0f;

RawBoxes raw(const Boxes& boxes) {
  return {{boxes.low[0].data(), boxes.low[1].data(), boxes.low[2].data()},
          {boxes.high[0].data(), boxes.high[1].data(), boxes.high[2].data()}};
}

template <typename T>
void make_room(std::vector<T>& values, int size) {
  if (values.size() < static_cast<std::size_t>(size)) values.resize(static_cast<std::size_t>(size));
}

}  // namespace

void NearestPoints::assign(const PointBlocks& points) {
  points_ = &points;
  const int most_blocks = static_cast<int>(points.levels().front().size()) + PointBlocks::kChildren;
  make_room(blocks_, most_blocks);
  make_room(nodes_, most_blocks);
}

void NearestPoints::search(std::span<const std::int32_t> slots, int count) {
  const RawBox around = set_queries(slots);
  const NearestKernel& kernel = nearest_kernel();
  std::array<std::int32_t, kQueries> found;
  for (;; radius2_ = std::min(kWidening * radius2_, kMostRadius2)) {
    gather_blocks(around);
    const int candidates = block_count_ * PointBlocks::kBlock;
    make_room(distances2_, candidates * kQueries);
    make_room(bits_, block_count_ / kBlocksOfWord * kQueries);
    kernel.distances2(points_->coordinates().data(), blocks_.data(), block_count_, queries_.data(), distances2_.data());
    bounds_.fill(radius2_);
    if (kernel.select(distances2_.data(), candidates, count, bounds_.data(), found.data(), bits_.data())) break;
  }
  drop_surplus(found, count);
  radius2_ = std::clamp(kRadiusMargin * *std::ranges::max_element(bounds_), kLeastRadius2, kMostRadius2);
}

void NearestPoints::narrow(int count) {
  std::array<std::int32_t, kQueries> found;
  nearest_kernel().select(distances2_.data(), block_count_ * PointBlocks::kBlock, count, bounds_.data(), found.data(), bits_.data());
  drop_surplus(found, count);
}

// Returns the box around them.
RawBox NearestPoints::set_queries(std::span<const std::int32_t> slots) {
  RawBox around;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    float* values = queries_.data() + kQueries * axis;
    for (std::size_t query = 0; query < kQueries; ++query) {
      const std::int32_t slot = slots[query < slots.size() ? query : 0];
      values[query] = points_->coordinates()[PointBlocks::place(slot) + PointBlocks::kBlock * axis];
    }
    around.low[axis] = *std::min_element(values, values + kQueries);
    around.high[axis] = *std::max_element(values, values + kQueries);
  }
  return around;
}

void NearestPoints::gather_blocks(const RawBox& around) {
  const std::span<const Boxes> levels = points_->levels();
  blocks_[0] = 0;  // above the top level, whose nodes are its children
  block_count_ = 1;
  for (std::size_t level = levels.size(); level-- > 0;) {
    std::swap(blocks_, nodes_);
    block_count_ = nearest_kernel().near_children(raw(levels[level]), nodes_.data(), block_count_, around, radius2_, blocks_.data());
  }
  while (block_count_ % kBlocksOfWord != 0) blocks_[static_cast<std::size_t>(block_count_++)] = points_->blocks();
}

void NearestPoints::drop_surplus(const std::array<std::int32_t, kQueries>& found, int count) {
  for (int query = 0; query < kQueries; ++query) {
    if (found[static_cast<std::size_t>(query)] > count) drop_farthest(query, count);
  }
}

// Of equally and of nearly equally far ones.
void NearestPoints::drop_farthest(int query, int count) {
  const auto lane = static_cast<std::size_t>(query);
  ranked_.clear();
  for (std::size_t word = lane, first = 0; word < nearest().size(); word += kQueries, first += 32) {
    for (std::uint32_t bits = bits_[word]; bits != 0; bits &= bits - 1) {
      const std::size_t candidate = first + static_cast<std::size_t>(std::countr_zero(bits));
      ranked_.push_back({distances2_[candidate * kQueries + lane], static_cast<std::uint32_t>(candidate)});
    }
    bits_[word] = 0;
  }
  std::ranges::nth_element(ranked_, ranked_.begin() + count);
  for (const Ranked& ranked : std::span(ranked_).first(static_cast<std::size_t>(count))) {
    bits_[ranked.candidate / 32 * kQueries + lane] |= 1U << ranked.candidate % 32;
  }
}

}  // namespace alignability::detail
