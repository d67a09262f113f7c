// SPDX-License-Identifier: BSD-3-Clause
#include "costmap/scanline.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace alignability::detail {
namespace {

struct Interval {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void extend(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

// A point in units of cells, the map's lower left corner at 0.
Eigen::Vector2d in_cells(const GridGeometry& geometry, const Eigen::Vector2d& point) {
  return (point - geometry.origin) / geometry.resolution;
}

// The x that a convex polygon (in cells) takes between two heights.
Interval width_between(const ConvexPolygon& polygon, double low, double high) {
  Interval width;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& a = polygon[i];
    const Eigen::Vector2d& b = polygon[(i + 1) % polygon.size()];
    if (a.y() >= low && a.y() <= high) width.extend(a.x());
    for (const double y : {low, high}) {
      if ((a.y() < y) != (b.y() < y)) width.extend(a.x() + (b.x() - a.x()) * (y - a.y()) / (b.y() - a.y()));
    }
  }
  return width;
}

struct IndexRange {
  int first;
  int last;  // inclusive
};

// Whole numbers from `low` to `high` that are indices of `count` cells; the comparison is made before the cast, which large numbers do not
// survive.
IndexRange indices(double low, double high, int count) {
  return {static_cast<int>(std::clamp(low, 0.0, static_cast<double>(count))), static_cast<int>(std::clamp(high, -1.0, count - 1.0))};
}

Interval height_of(const ConvexPolygon& polygon) {
  Interval height;
  for (const Eigen::Vector2d& corner : polygon) height.extend(corner.y());
  return height;
}

// An interval of some length without the last thousandth of a cell at its ends: what reaches no further into a cell only brushes it.
// Corners are rounded, and a wall that ends on a cell's edge is not to take the next cell.
Interval without_brushes(const Interval& interval) {
  constexpr double kBrush = 1e-3;
  if (interval.high - interval.low <= 2.0 * kBrush) return interval;
  return {interval.low + kBrush, interval.high - kBrush};
}

ConvexPolygon in_cells(const GridGeometry& geometry, const ConvexPolygon& polygon) {
  ConvexPolygon result;
  result.reserve(polygon.size());
  for (const Eigen::Vector2d& corner : polygon) result.push_back(in_cells(geometry, corner));
  return result;
}

void visit_row(int row, IndexRange columns, const CellVisitor& visit) {
  for (int column = columns.first; column <= columns.last; ++column) visit({column, row});
}

}  // namespace

void visit_touched(const GridGeometry& geometry, const ConvexPolygon& polygon, const CellVisitor& visit) {
  const ConvexPolygon corners = in_cells(geometry, polygon);
  const Interval height = without_brushes(height_of(corners));
  const Interval reach = without_brushes(width_between(corners, height.low, height.high));
  const IndexRange rows = indices(std::floor(height.low), std::floor(height.high), geometry.height);
  for (int row = rows.first; row <= rows.last; ++row) {
    const Interval width = width_between(corners, row, row + 1.0);
    visit_row(row, indices(std::floor(std::max(width.low, reach.low)), std::floor(std::min(width.high, reach.high)), geometry.width),
              visit);
  }
}

void visit_covered(const GridGeometry& geometry, const ConvexPolygon& polygon, const CellVisitor& visit) {
  const ConvexPolygon corners = in_cells(geometry, polygon);
  const Interval height = height_of(corners);
  const IndexRange rows = indices(std::floor(height.low), std::floor(height.high), geometry.height);
  for (int row = rows.first; row <= rows.last; ++row) {
    const Interval width = width_between(corners, row + 0.5, row + 0.5);
    visit_row(row, indices(std::ceil(width.low - 0.5), std::floor(width.high - 0.5), geometry.width), visit);
  }
}

void visit_enclosed(const GridGeometry& geometry, std::span<const DirectedEdge> edges, const CellVisitor& visit) {
  struct Crossing {
    double x;
    int winding;
  };
  std::vector<std::vector<Crossing>> crossings(static_cast<std::size_t>(geometry.height));
  for (const DirectedEdge& edge : edges) {
    const Eigen::Vector2d from = in_cells(geometry, edge.from);
    const Eigen::Vector2d to = in_cells(geometry, edge.to);
    const auto [low, high] = std::minmax(from.y(), to.y());
    // The centres of rows r with low <= r + 1/2 < high, so that where two edges meet exactly one of them counts.
    const IndexRange rows = indices(std::ceil(low - 0.5), std::ceil(high - 0.5) - 1.0, geometry.height);
    for (int row = rows.first; row <= rows.last; ++row) {
      const double x = from.x() + (to.x() - from.x()) * (row + 0.5 - from.y()) / (to.y() - from.y());
      crossings[static_cast<std::size_t>(row)].push_back({x, to.y() < from.y() ? 1 : -1});
    }
  }
  for (int row = 0; row < geometry.height; ++row) {
    auto& line = crossings[static_cast<std::size_t>(row)];
    std::ranges::sort(line, {}, &Crossing::x);
    int winding = 0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      winding += line[i].winding;
      if (winding >= 1) visit_row(row, indices(std::ceil(line[i].x - 0.5), std::ceil(line[i + 1].x - 0.5) - 1.0, geometry.width), visit);
    }
  }
}

}  // namespace alignability::detail
