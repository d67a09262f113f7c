// SPDX-License-Identifier: BSD-3-Clause
#include "costmap/occupancy_map.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "costmap/scanline.hpp"

namespace alignability {

OccupancyMap::OccupancyMap(Grid<float> occupancy) : occupancy_(std::move(occupancy)) {
  const bool valid =
      std::ranges::all_of(occupancy_.values(), [](float value) { return std::isnan(value) || (value >= 0.0f && value <= 1.0f); });
  if (!valid) throw std::invalid_argument("occupancy must be from 0 to 1, or NaN where unknown");
}

std::optional<float> OccupancyMap::occupancy(Cell cell) const {
  const float value = occupancy_[cell];
  return std::isnan(value) ? std::nullopt : std::optional(value);
}

OccupancyMap rasterize(const Slice& slice, const GridGeometry& geometry) {
  constexpr float kFree = 0.0f;
  constexpr float kOccupied = 1.0f;
  Grid<float> occupancy(geometry, std::numeric_limits<float>::quiet_NaN());
  const auto set_to = [&](float value) { return [&occupancy, value](Cell cell) { occupancy[cell] = value; }; };
  for (const ConvexPolygon& floor : slice.floors) detail::visit_covered(geometry, floor, set_to(kFree));
  detail::visit_enclosed(geometry, slice.solid_edges, set_to(kOccupied));
  for (const ConvexPolygon& surface : slice.surfaces) detail::visit_touched(geometry, surface, set_to(kOccupied));
  return OccupancyMap(std::move(occupancy));
}

GridGeometry geometry_around(const Slice& slice, double resolution) {
  if (!(resolution > 0.0)) throw std::invalid_argument("a resolution must be greater than 0");
  Eigen::AlignedBox2d box;
  for (const ConvexPolygon& surface : slice.surfaces) {
    for (const Eigen::Vector2d& corner : surface) box.extend(corner);
  }
  if (box.isEmpty()) throw std::invalid_argument("no surface lies in the slice");
  // A corner within a thousandth of a cell's edge lies on it: worlds give decimals, meshes single precision.
  constexpr double kSlack = 1e-3;
  const Eigen::Array2d low = (box.min().array() / resolution + kSlack).floor();
  const Eigen::Array2d high = (box.max().array() / resolution - kSlack).ceil().max(low + 1.0);
  const Eigen::Array2d cells = high - low;
  if (!(cells.prod() <= std::numeric_limits<std::int32_t>::max()))
    throw std::invalid_argument("the slice has too many cells at that resolution");
  return {.resolution = resolution,
          .origin = resolution * low.matrix(),
          .width = static_cast<int>(cells.x()),
          .height = static_cast<int>(cells.y())};
}

}  // namespace alignability
