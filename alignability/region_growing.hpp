// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace alignability::detail {

/// A point as region growing sees it.
struct SurfaceNormal {
  float x = 0.0f;
  float y = 0.0f;
  float z = 0.0f;
  float curvature = 0.0f;  ///< λ_min over the trace of its neighbourhood's covariance
};

/// Points in blocks of eight, and whom each may draw into its segment: the bits of its words, as NearestPoints has them.
struct NeighbourGraph {
  struct Links {
    std::uint32_t word = 0;   ///< the first, in `blocks` four times as far
    std::uint32_t words = 0;  ///< how many
    std::uint32_t lane = 0;   ///< which of the eight of each word
  };

  std::vector<std::uint8_t> points;    ///< of each block the slots that hold a point; one more, without, at the end
  std::vector<SurfaceNormal> normals;  ///< of each slot
  std::vector<Links> links;            ///< of each slot
  std::vector<std::int32_t> blocks;    ///< four a word: whom its bits stand for
  std::vector<std::uint32_t> bits;     ///< eight a word
};

struct GrowingOptions {
  float cosine;     ///< least |cos| of the angle between the normals of a point and one it draws in
  float curvature;  ///< a point above it draws in no others, but where a segment begins
  int min_points;   ///< a smaller segment is none, its points taken all the same
};

/// Smoothness-constrained region growing (Rabbani et al. 2006) as PCL's RegionGrowing does it: segments begin at the points of least
/// curvature, of equal ones at the first. O(points · links + points · log points). Keeps its memory.
class RegionGrower {
 public:
  void grow(const NeighbourGraph& graph, const GrowingOptions& options);
  /// The slots of the segments one after the other, and where each ends; valid until the next call.
  const std::vector<std::int32_t>& members() const { return members_; }
  const std::vector<std::size_t>& ends() const { return ends_; }

 private:
  void sort_seeds(const NeighbourGraph& graph);
  void grow_from(std::int32_t seed, const NeighbourGraph& graph, const GrowingOptions& options);
  bool take(std::int32_t slot);

  std::vector<std::uint64_t> seeds_;
  std::vector<std::uint64_t> bucketed_;
  std::vector<std::uint32_t> bucket_ends_;
  std::vector<std::uint8_t> free_;  // of each block the slots whose points are in no segment yet
  std::vector<std::int32_t> members_;
  std::vector<std::size_t> ends_;
};

}  // namespace alignability::detail
