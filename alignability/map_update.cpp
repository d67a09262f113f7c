// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/map_update.hpp"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/ring.hpp>
#include <cmath>
#include <stdexcept>
#include <string>

namespace alignability {
namespace {

namespace bg = boost::geometry;
using Point = bg::model::d2::point_xy<double>;

void check_alike(const AlignabilityMap& before, const AlignabilityMap& rebuilt) {
  const auto demand = [](bool alike, const char* what) {
    if (!alike) throw std::invalid_argument(std::string("the map to update was made with another ") + what);
  };
  demand(before.geometry == rebuilt.geometry, "grid");
  demand(before.sensor == rebuilt.sensor, "sensor file");
  demand(before.seed == rebuilt.seed, "seed");
  demand(before.options == rebuilt.options, "choice of options");
  demand(std::ranges::equal(before.layers, rebuilt.layers, {}, &AlignabilityMap::Layer::name, &AlignabilityMap::Layer::name),
         "choice of layers");
}

}  // namespace

std::vector<Cell> cells_meeting(const GridGeometry& geometry, std::span<const Eigen::Vector2d> polygon) {
  if (polygon.size() < 3) throw std::invalid_argument("a polygon has at least three corners");
  bg::model::ring<Point> ring;
  for (const Eigen::Vector2d& corner : polygon) {
    if (!corner.allFinite()) throw std::invalid_argument("a polygon's corners must be finite");
    ring.emplace_back(corner.x(), corner.y());
  }
  bg::correct(ring);
  const auto box = bg::return_envelope<bg::model::box<Point>>(ring);
  const auto index = [&](double value, int axis, int size) {
    return static_cast<int>(std::clamp(std::floor((value - geometry.origin[axis]) / geometry.resolution), 0.0, size - 1.0));
  };
  std::vector<Cell> cells;
  for (int y = index(box.min_corner().y(), 1, geometry.height); y <= index(box.max_corner().y(), 1, geometry.height); ++y) {
    for (int x = index(box.min_corner().x(), 0, geometry.width); x <= index(box.max_corner().x(), 0, geometry.width); ++x) {
      const Eigen::Vector2d low = geometry.corner({x, y}), high = geometry.corner({x + 1, y + 1});
      if (bg::intersects(bg::model::box<Point>({low.x(), low.y()}, {high.x(), high.y()}), ring)) cells.push_back({x, y});
    }
  }
  return cells;
}

AlignabilityMap updated(const AlignabilityMap& before, AlignabilityMap rebuilt, std::span<const Cell> cells) {
  check_alike(before, rebuilt);
  for (std::size_t layer = 0; layer < rebuilt.layers.size(); ++layer) {
    Grid<float> values = before.layers[layer].values;
    for (const Cell cell : cells) values[cell] = rebuilt.layers[layer].values[cell];
    rebuilt.layers[layer].values = std::move(values);
  }
  return rebuilt;
}

}  // namespace alignability
