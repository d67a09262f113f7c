// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/region_growing.hpp"

#include <bit>
#include <boost/sort/spreadsort/integer_sort.hpp>
#include <cmath>

namespace alignability::detail {

void RegionGrower::grow(const NeighbourGraph& graph, const GrowingOptions& options) {
  members_.clear();
  ends_.clear();
  taken_.assign(graph.normals.size(), 0);
  sort_seeds(graph.normals);
  for (const std::uint64_t key : seeds_) {
    const auto seed = static_cast<std::int32_t>(key & 0xffffffffU);
    if (taken_[static_cast<std::size_t>(seed)] != 0) continue;
    const std::size_t begin = members_.size();
    grow_from(seed, graph, options);
    if (members_.size() - begin < static_cast<std::size_t>(options.min_points)) {
      members_.resize(begin);
    } else {
      ends_.push_back(members_.size());
    }
  }
}

// The bits of floats that are not negative are in their order; those of the place behind make every key another.
void RegionGrower::sort_seeds(const std::vector<SurfaceNormal>& normals) {
  seeds_.clear();
  for (std::size_t i = 0; i < normals.size(); ++i) {
    seeds_.push_back(std::uint64_t{std::bit_cast<std::uint32_t>(normals[i].curvature)} << 32 | i);
  }
  boost::sort::spreadsort::integer_sort(seeds_.begin(), seeds_.end());
}

void RegionGrower::grow_from(std::int32_t seed, const NeighbourGraph& graph, const GrowingOptions& options) {
  std::size_t next = members_.size();
  members_.push_back(seed);
  taken_[static_cast<std::size_t>(seed)] = 1;
  for (; next < members_.size(); ++next) {
    const auto i = static_cast<std::size_t>(members_[next]);
    const SurfaceNormal& from = graph.normals[i];
    if (from.curvature > options.curvature && members_[next] != seed) continue;
    const std::int32_t* links = graph.links.data() + i * static_cast<std::size_t>(graph.most_links);
    for (std::int32_t k = 0; k < graph.links_of[i]; ++k) {
      const auto to = static_cast<std::size_t>(links[k]);
      if (taken_[to] != 0) continue;
      const SurfaceNormal& normal = graph.normals[to];
      if (!(std::abs(normal.x * from.x + normal.y * from.y + normal.z * from.z) >= options.cosine)) continue;
      taken_[to] = 1;
      members_.push_back(links[k]);
    }
  }
}

}  // namespace alignability::detail
