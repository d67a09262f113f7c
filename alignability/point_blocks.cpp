// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/point_blocks.hpp"

#include <algorithm>
#include <limits>

namespace alignability::detail {
namespace {

constexpr double kFarthest = 1e15;  // [m]
constexpr float kInfinity = std::numeric_limits<float>::infinity();

// A block of an organized scan ends where the surface does: where the next point is farther than this share of the range, squared.
constexpr float kJump2 = 0.1f * 0.1f;

void resize(Boxes& boxes, std::size_t size) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    boxes.low[axis].assign(size, kInfinity);
    boxes.high[axis].assign(size, -kInfinity);
  }
}

std::size_t padded(std::size_t size) {
  constexpr auto kWhole = static_cast<std::size_t>(PointBlocks::kChildren);
  return (size + kWhole - 1) / kWhole * kWhole;
}

}  // namespace

bool counts(const Eigen::Vector3f& point, double range_min) {
  const double range = point.cast<double>().norm();
  return range >= range_min && range <= kFarthest;
}

void PointBlocks::assign(const Scan& scan, double range_min) {
  kept_.clear();
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    if (counts(scan.points[i], range_min)) kept_.push_back({scan.points[i], static_cast<std::int32_t>(i)});
  }
  scan_index_.clear();
  if (scan.organized()) {
    keep_order(scan.columns);
    tile(scan.columns);
  } else {
    halve(kept_);
  }
  coordinates_.assign(3 * (scan_index_.size() + kBlock), kInfinity);
  for (std::size_t slot = 0; slot < scan_index_.size(); ++slot) {
    if (scan_index_[slot] < 0) continue;
    const Eigen::Vector3f& point = scan.points[static_cast<std::size_t>(scan_index_[slot])];
    float* place = coordinates_.data() + PointBlocks::place(static_cast<std::int32_t>(slot));
    for (int axis = 0; axis < 3; ++axis) place[kBlock * axis] = point[axis];
  }
  build_boxes();
}

void PointBlocks::pad_block() {
  while (scan_index_.size() % kBlock != 0) scan_index_.push_back(-1);
}

void PointBlocks::keep_order(int columns) {
  for (std::size_t k = 0; k < kept_.size(); ++k) {
    if (k > 0) {
      const Eigen::Vector3f& before = kept_[k - 1].point;
      const bool same_ring = kept_[k].index / columns == kept_[k - 1].index / columns;
      if (!same_ring || (kept_[k].point - before).squaredNorm() > kJump2 * before.squaredNorm()) pad_block();
    }
    scan_index_.push_back(kept_[k].index);
  }
  pad_block();
}

// Tiles of 4 × 4 blocks of four rings, and tiles of 4 × 4 of these, are boxes that hold little but what is near one another, where a row of
// blocks along a ring would reach around half the sensor.
void PointBlocks::tile(int columns) {
  order_.clear();
  for (std::int32_t block = 0; block < blocks(); ++block) {
    const std::int32_t first = scan_index_[static_cast<std::size_t>(block) * kBlock];
    const auto ring = static_cast<std::uint64_t>(first / columns);
    const auto column = static_cast<std::uint64_t>(first % columns);
    const std::uint64_t large = (ring >> 4) << 32 | column >> 7;
    order_.push_back({(((large << 2 | (ring >> 2 & 3)) << 2 | (column >> 5 & 3)) << 2 | (ring & 3)) << 7 | (column & 127), block});
  }
  std::ranges::sort(order_);
  tiled_.clear();
  for (const Placed& placed : order_) {
    const auto begin = scan_index_.begin() + static_cast<std::ptrdiff_t>(placed.block) * kBlock;
    tiled_.insert(tiled_.end(), begin, begin + kBlock);
  }
  scan_index_.swap(tiled_);
}

void PointBlocks::halve(std::span<Kept> part) {
  if (part.size() <= kBlock) {
    for (const Kept& kept : part) scan_index_.push_back(kept.index);
    pad_block();
    return;
  }
  Eigen::Array3f low = part.front().point.array();
  Eigen::Array3f high = low;
  for (const Kept& kept : part) {
    low = low.min(kept.point.array());
    high = high.max(kept.point.array());
  }
  int axis = 0;
  (high - low).maxCoeff(&axis);
  const std::size_t half = (part.size() / 2 + kBlock - 1) / kBlock * kBlock;  // of whole blocks
  const auto before = [axis](const Kept& a, const Kept& b) {
    return a.point[axis] != b.point[axis] ? a.point[axis] < b.point[axis] : a.index < b.index;
  };
  std::nth_element(part.begin(), part.begin() + static_cast<std::ptrdiff_t>(half), part.end(), before);
  halve(part.first(half));
  halve(part.subspan(half));
}

void PointBlocks::build_boxes() {
  const std::size_t size = scan_index_.size() / kBlock;
  if (levels_.empty()) levels_.emplace_back();
  resize(levels_[0], padded(size));
  for (std::size_t block = 0; block < size; ++block) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float* values = coordinates_.data() + 3 * kBlock * block + kBlock * axis;
      float low = kInfinity;
      float high = -kInfinity;
      for (int lane = 0; lane < kBlock; ++lane) {
        low = std::min(low, values[lane]);
        high = std::max(high, values[lane] < kInfinity ? values[lane] : -kInfinity);
      }
      levels_[0].low[axis][block] = low;
      levels_[0].high[axis][block] = high;
    }
  }
  std::size_t level = 1;
  for (std::size_t nodes = size; nodes > kChildren; ++level) {
    nodes = padded(nodes) / kChildren;
    if (levels_.size() == level) levels_.emplace_back();
    resize(levels_[level], padded(nodes));
    const Boxes& below = levels_[level - 1];
    Boxes& boxes = levels_[level];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::size_t i = 0; i < below.size(); ++i) {
        boxes.low[axis][i / kChildren] = std::min(boxes.low[axis][i / kChildren], below.low[axis][i]);
        boxes.high[axis][i / kChildren] = std::max(boxes.high[axis][i / kChildren], below.high[axis][i]);
      }
    }
  }
  level_count_ = level;
}

}  // namespace alignability::detail
