// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "lidar/scan.hpp"

namespace alignability::detail {

/// Whether a return is scored: finite, at least `range_min` from the sensor and no farther than squares of floats reach.
bool counts(const Eigen::Vector3f& point, double range_min);

/// Boxes along x, y and z. One that holds nothing is [inf, -inf] and infinitely far from all.
struct Boxes {
  std::array<std::vector<float>, 3> low;
  std::array<std::vector<float>, 3> high;

  std::size_t size() const { return low[0].size(); }
};

/// The points of a scan, near ones near one another in memory, in blocks of eight; a tree of boxes over the blocks, sixteen to one above.
/// The blocks of an organized scan are pieces of its rings, tile by tile; another scan is halved along its longest side until eight points
/// are left.
class PointBlocks {
 public:
  static constexpr int kBlock = 8;
  static constexpr int kChildren = 16;

  /// Takes the points of a scan that count; keeps the memory of the scan before.
  void assign(const Scan& scan, double range_min);

  std::size_t points() const { return kept_.size(); }
  int blocks() const { return static_cast<int>(scan_index_.size()) / kBlock; }
  /// The place in the scan of each slot, eight a block; -1 = empty, its coordinates infinite.
  const std::vector<std::int32_t>& scan_index() const { return scan_index_; }
  /// Block after block eight x, eight y, eight z; after the last a block of which every slot is empty.
  const std::vector<float>& coordinates() const { return coordinates_; }
  /// Where in `coordinates` the x of a slot is; its y and z are eight and sixteen after it.
  static std::size_t place(std::int32_t slot) { return static_cast<std::size_t>(slot + (slot / kBlock) * 2 * kBlock); }
  /// The boxes of the blocks, then of each level above; a level's size is a whole number of `kChildren`.
  std::span<const Boxes> levels() const { return std::span(levels_).first(level_count_); }

 private:
  struct Kept {
    Eigen::Vector3f point;
    std::int32_t index;
  };

  // A block and the tile that it belongs to.
  struct Placed {
    std::uint64_t tile;
    std::int32_t block;
    auto operator<=>(const Placed&) const = default;
  };

  void keep_order(int columns);
  void tile(int columns);
  void halve(std::span<Kept> part);
  void pad_block();
  void build_boxes();

  std::vector<Kept> kept_;
  std::vector<Placed> order_;
  std::vector<std::int32_t> tiled_;
  std::vector<std::int32_t> scan_index_;
  std::vector<float> coordinates_;
  std::vector<Boxes> levels_;  // those of the largest scan so far
  std::size_t level_count_ = 0;
};

}  // namespace alignability::detail
