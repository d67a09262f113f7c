// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/nearest.hpp"

#include <algorithm>
#include <limits>

#include "alignability/nearest_kernel.hpp"
#include "alignability/point_blocks.hpp"

namespace alignability::detail {
namespace {

constexpr int kLanes = PointBlocks::kBlock;
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kLeastRadius2 = 1e-12f;
// Blocks are gathered once for eight points, whose radii differ.
constexpr float kRadiusMargin = 1.15f;
constexpr float kGatherMargin = 1.5f;

RawBoxes raw(const Boxes& boxes) {
  return {{boxes.low[0].data(), boxes.low[1].data(), boxes.low[2].data()},
          {boxes.high[0].data(), boxes.high[1].data(), boxes.high[2].data()}};
}

int whole_lanes(int count) { return (count + kLanes - 1) / kLanes * kLanes; }

// On a surface a disk holds points as its area is.
float widening(int wanted, int found) { return std::clamp(1.3f * static_cast<float>(wanted) / static_cast<float>(found), 1.3f, 16.0f); }

template <typename T>
void make_room(std::vector<T>& values, int size) {
  if (values.size() < static_cast<std::size_t>(size)) values.resize(static_cast<std::size_t>(size));
}

}  // namespace

void NearestPoints::assign(const PointBlocks& points) {
  points_ = &points;
  block_ = -1;
  const int most_blocks = static_cast<int>(points.levels().front().size()) + kLanes;
  make_room(blocks_, most_blocks);
  make_room(nodes_, most_blocks);
}

std::span<const std::int32_t> NearestPoints::search(int slot, int count) {
  const int block = slot / kLanes;
  for (;; radius2_ *= widening(count, candidates_)) {
    if (block != block_ || radius2_ > gathered2_) gather_blocks(block, kGatherMargin * radius2_);
    gather_slots(slot);
    if (candidates_ >= count) break;
  }
  sort();
  radius2_ = std::max(kRadiusMargin * distance2(slot, sorted_[static_cast<std::size_t>(count) - 1]), kLeastRadius2);
  return std::span(sorted_).first(static_cast<std::size_t>(count));
}

float NearestPoints::distance2(std::int32_t a, std::int32_t b) const {
  const float* from = points_->coordinates().data() + PointBlocks::place(a);
  const float* to = points_->coordinates().data() + PointBlocks::place(b);
  float sum = 0.0f;
  for (int axis = 0; axis < 3; ++axis) sum += (to[kLanes * axis] - from[kLanes * axis]) * (to[kLanes * axis] - from[kLanes * axis]);
  return sum;
}

void NearestPoints::gather_blocks(int block, float radius2) {
  block_ = block;
  gathered2_ = radius2;
  const std::vector<Boxes>& levels = points_->levels();
  RawBox query;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    query.low[axis] = levels[0].low[axis][static_cast<std::size_t>(block)];
    query.high[axis] = levels[0].high[axis][static_cast<std::size_t>(block)];
  }
  blocks_[0] = 0;  // above the top level, whose nodes are its children
  block_count_ = 1;
  for (std::size_t level = levels.size(); level-- > 0;) {
    std::swap(blocks_, nodes_);
    block_count_ = nearest_kernel().near_children(raw(levels[level]), nodes_.data(), block_count_, query, radius2, blocks_.data());
  }
}

void NearestPoints::gather_slots(int slot) {
  const float* coordinates = points_->coordinates().data();
  const float* place = coordinates + PointBlocks::place(slot);
  const float point[3] = {place[0], place[kLanes], place[2 * kLanes]};
  const int most = kLanes * (block_count_ + 1);
  make_room(slots_, most);
  make_room(distances2_, most);
  candidates_ = nearest_kernel().near_slots(coordinates, blocks_.data(), block_count_, point, radius2_, slots_.data(), distances2_.data());
}

void NearestPoints::sort() {
  const int lanes = whole_lanes(candidates_);
  make_room(ranks_, lanes);
  make_room(sorted_, lanes);
  std::fill(distances2_.begin() + candidates_, distances2_.begin() + lanes, kInfinity);
  nearest_kernel().rank(distances2_.data(), lanes, ranks_.data());
  const std::int32_t* ranks = ranks_.data();
  const std::int32_t* slots = slots_.data();
  std::int32_t* sorted = sorted_.data();
  for (int i = 0; i < candidates_; ++i) sorted[ranks[i]] = slots[i];
}

}  // namespace alignability::detail
