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

/// Points and whom each may draw into its segment.
struct NeighbourGraph {
  std::vector<SurfaceNormal> normals;
  int most_links = 0;
  std::vector<std::int32_t> links;     ///< of point i from `i * most_links` on
  std::vector<std::int32_t> links_of;  ///< how many of them
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
  /// The members of the segments one after the other, and where each ends; valid until the next call.
  void grow(const NeighbourGraph& graph, const GrowingOptions& options);
  const std::vector<std::int32_t>& members() const { return members_; }
  const std::vector<std::size_t>& ends() const { return ends_; }

 private:
  void sort_seeds(const std::vector<SurfaceNormal>& normals);
  void grow_from(std::int32_t seed, const NeighbourGraph& graph, const GrowingOptions& options);

  std::vector<std::uint64_t> seeds_;
  std::vector<std::uint8_t> taken_;
  std::vector<std::int32_t> members_;
  std::vector<std::size_t> ends_;
};

}  // namespace alignability::detail
