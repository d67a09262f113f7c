// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/map_update.hpp"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/ring.hpp>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

namespace alignability {
namespace {

namespace bg = boost::geometry;
using Point = bg::model::d2::point_xy<double>;

// The first lines in which two texts differ.
std::string difference(const std::string& before, const std::string& now) {
  std::istringstream lines_before(before), lines_now(now);
  std::string line_before, line_now;
  do {
    line_before.clear();
    line_now.clear();
    std::getline(lines_before, line_before);
    std::getline(lines_now, line_now);
  } while (line_before == line_now && (lines_before || lines_now));
  return "'" + line_before + "', not '" + line_now + "'";
}

void check_alike(const AlignabilityMap& before, const AlignabilityMap& rebuilt) {
  if (before.geometry != rebuilt.geometry) throw std::invalid_argument("has another grid");
  if (before.sensor != rebuilt.sensor) throw std::invalid_argument("was made with another sensor file");
  if (before.seed != rebuilt.seed) {
    throw std::invalid_argument("was made with the seed " + std::to_string(before.seed) + ", not " + std::to_string(rebuilt.seed));
  }
  if (before.options != rebuilt.options) throw std::invalid_argument("was made with " + difference(before.options, rebuilt.options));
  if (!std::ranges::equal(before.layers, rebuilt.layers, {}, &AlignabilityMap::Layer::name, &AlignabilityMap::Layer::name)) {
    throw std::invalid_argument("has other layers");
  }
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
