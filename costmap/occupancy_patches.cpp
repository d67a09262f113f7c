// SPDX-License-Identifier: BSD-3-Clause
#include "costmap/occupancy_patches.hpp"

#include <limits>
#include <utility>
#include <vector>

namespace alignability {
namespace {

enum class Kind : char { free, occupied, unknown };

struct Patch {
  Kind kind;
  std::vector<Cell> cells;
  bool is_amid_free = true;  // not at the map's edge either
};

Kind kind_of(const OccupancyMap& map, Cell cell) {
  if (!map.occupancy(cell)) return Kind::unknown;
  return map.is_free(cell) ? Kind::free : Kind::occupied;
}

Patch patch_around(const OccupancyMap& map, Cell start, std::vector<char>& seen) {
  const GridGeometry& grid = map.geometry();
  Patch patch{.kind = kind_of(map, start), .cells = {start}};
  seen[grid.index(start)] = 1;
  for (std::size_t i = 0; i < patch.cells.size(); ++i) {
    const auto [x, y] = patch.cells[i];
    for (const Cell next : {Cell{x - 1, y}, Cell{x + 1, y}, Cell{x, y - 1}, Cell{x, y + 1}}) {
      if (!grid.contains(next) || kind_of(map, next) != patch.kind) {
        patch.is_amid_free = patch.is_amid_free && map.is_free(next);
      } else if (std::exchange(seen[grid.index(next)], 1) == 0) {
        patch.cells.push_back(next);
      }
    }
  }
  return patch;
}

// The map with the cells of the patches that are to change at that value.
template <typename IsChanged>
OccupancyMap changed(const OccupancyMap& map, float value, IsChanged is_changed) {
  const GridGeometry& grid = map.geometry();
  Grid<float> occupancy(grid, std::numeric_limits<float>::quiet_NaN());
  std::vector<char> seen(grid.size());
  for (std::size_t i = 0; i < grid.size(); ++i) {
    if (seen[i] != 0) continue;
    const Patch patch = patch_around(map, grid.cell_of(i), seen);
    const bool is_new = is_changed(patch);
    for (const Cell cell : patch.cells) {
      occupancy[cell] = is_new ? value : map.occupancy(cell).value_or(std::numeric_limits<float>::quiet_NaN());
    }
  }
  return OccupancyMap(std::move(occupancy));
}

double area_of(const Patch& patch, const OccupancyMap& map) {
  return static_cast<double>(patch.cells.size()) * map.geometry().resolution * map.geometry().resolution;
}

}  // namespace

OccupancyMap without_small_patches(const OccupancyMap& map, double area) {
  return changed(map, std::numeric_limits<float>::quiet_NaN(),
                 [&](const Patch& patch) { return patch.kind == Kind::free && area_of(patch, map) < area; });
}

OccupancyMap without_small_holes(const OccupancyMap& map, double area) {
  return changed(map, 0.0f,
                 [&](const Patch& patch) { return patch.kind == Kind::unknown && patch.is_amid_free && area_of(patch, map) < area; });
}

}  // namespace alignability
