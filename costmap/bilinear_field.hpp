// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "costmap/arc_traversal.hpp"
#include "costmap/bilinear_along_arc.hpp"
#include "costmap/grid.hpp"
#include "costmap/quadratic.hpp"
#include "costmap/traversal.hpp"

namespace alignability {

/// A function of the plane given by its values at cell centres, bilinear between four of them and constant across beyond the outermost.
/// Where a value is NaN, so is every patch between centres that has it for a corner. Immutable; queries allocate nothing.
class BilinearField {
 public:
  BilinearField() = default;
  explicit BilinearField(Grid<double> nodes) : nodes_(std::move(nodes)) {}

  const Grid<double>& nodes() const { return nodes_; }

  double at(const Eigen::Vector2d& point) const;

  /// ∫ f ds over the segment [value · m], in closed form; the same to the bit in either direction. O(patches crossed).
  double integral(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const;
  /// Along an arc, in closed form likewise: to 1e-9 of the field's greatest value times the length, for
  /// radii up to 10^5 m.
  double integral(const Arc& arc) const;

  /// Calls `visit(share, quadratic)` for each piece of the segment that lies in one patch, in order: the piece is that share of the
  /// segment's length, and the field along it, from s = 0 to s = 1, is the quadratic. The shares add up to 1.
  template <typename Visitor>
  void visit(const Eigen::Vector2d& from, const Eigen::Vector2d& to, Visitor&& visitor) const;

  /// Calls `visitor(const BilinearAlongArc&)` for each piece of the arc that lies in one patch, in order; an arc of no length has none.
  template <typename Visitor>
  void visit(const Arc& arc, Visitor&& visitor) const;

 private:
  friend class HeadingField;  // whose pieces are those of patches, cut at headings

  // The grid whose cells are the patches: its lines run through the centres.
  GridGeometry patches() const;
  struct Corners {
    double low_left, low_right, high_left, high_right;
  };
  // Beyond the outermost centres, those of the nearest patch's edge twice.
  Corners corners_of(Cell patch) const;
  double in_patch(Cell patch, const Eigen::Vector2d& point) const;
  BilinearAlongArc along(const Arc& arc, Cell patch, double begin, double end) const;
  Quadratic along(const Eigen::Vector2d& from, const Eigen::Vector2d& step, Cell patch, double begin, double end) const;

  Grid<double> nodes_;
};

inline GridGeometry BilinearField::patches() const {
  GridGeometry patches = nodes_.geometry();
  patches.origin.array() += 0.5 * patches.resolution;
  --patches.width;
  --patches.height;
  return patches;
}

inline BilinearField::Corners BilinearField::corners_of(Cell patch) const {
  const GridGeometry& grid = nodes_.geometry();
  const auto row = static_cast<std::size_t>(grid.width);
  const std::size_t low = grid.index({std::max(patch.x, 0), std::max(patch.y, 0)});
  const std::size_t across = patch.x >= 0 && patch.x + 1 < grid.width ? 1 : 0;
  const std::size_t up = patch.y >= 0 && patch.y + 1 < grid.height ? row : 0;
  return {nodes_[low], nodes_[low + across], nodes_[low + up], nodes_[low + up + across]};
}

inline double BilinearField::in_patch(Cell patch, const Eigen::Vector2d& point) const {
  const GridGeometry& grid = nodes_.geometry();
  const Corners corner = corners_of(patch);
  const Cell low{std::max(patch.x, 0), std::max(patch.y, 0)};
  const Eigen::Array2d at = ((point - grid.center(low)) / grid.resolution).array().cwiseMax(0.0).cwiseMin(1.0);
  const double below = corner.low_left + at.x() * (corner.low_right - corner.low_left);
  const double above = corner.high_left + at.x() * (corner.high_right - corner.high_left);
  return below + at.y() * (above - below);
}

inline Quadratic BilinearField::along(const Eigen::Vector2d& from, const Eigen::Vector2d& step, Cell patch, double begin,
                                      double end) const {
  // Three values determine a quadratic.
  const double first = in_patch(patch, from + begin * step);
  const double middle = in_patch(patch, from + 0.5 * (begin + end) * step);
  const double last = in_patch(patch, from + end * step);
  return {first, 4.0 * middle - 3.0 * first - last, 2.0 * (first + last) - 4.0 * middle};
}

template <typename Visitor>
void BilinearField::visit(const Eigen::Vector2d& from, const Eigen::Vector2d& to, Visitor&& visitor) const {
  const Eigen::Vector2d step = to - from;
  detail::traverse(patches(), from, to,
                   [&](Cell patch, double begin, double end) { visitor(end - begin, along(from, step, patch, begin, end)); });
}

template <typename Visitor>
void BilinearField::visit(const Arc& arc, Visitor&& visitor) const {
  if (arc.travel == 0.0) return;
  detail::traverse(patches(), arc, [&](Cell patch, double begin, double end) { visitor(along(arc, patch, begin, end)); });
}

}  // namespace alignability
