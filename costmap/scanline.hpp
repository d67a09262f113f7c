// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <span>

#include "core/polygon.hpp"
#include "costmap/grid.hpp"

namespace alignability::detail {

using CellVisitor = std::function<void(Cell)>;

/// The cells that a polygon reaches into, boundary included, by more than a thousandth of a cell where it goes on; a cell owns its left and
/// lower edge.
void visit_touched(const GridGeometry& geometry, const ConvexPolygon& polygon, const CellVisitor& visit);

/// The cells whose centre lies in a polygon, boundary included.
void visit_covered(const GridGeometry& geometry, const ConvexPolygon& polygon, const CellVisitor& visit);

/// The cells whose centre the edges wind around at least once, counter-clockwise.
void visit_enclosed(const GridGeometry& geometry, std::span<const DirectedEdge> edges, const CellVisitor& visit);

}  // namespace alignability::detail
