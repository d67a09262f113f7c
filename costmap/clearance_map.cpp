// SPDX-License-Identifier: BSD-3-Clause
#include "costmap/clearance_map.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace alignability {
namespace {

double squared(double value) { return value * value; }

// How far a coordinate lies outside of [low, low + 1].
double outside_unit(double value, double low) { return std::max({0.0, low - value, value - low - 1.0}); }

Grid<std::int32_t> column_gaps(const OccupancyMap& occupancy) {
  const GridGeometry& geometry = occupancy.geometry();
  Grid<std::int32_t> gaps(geometry, geometry.height);
  for (int y = 0; y < geometry.height; ++y) {
    for (int x = 0; x < geometry.width; ++x) {
      const std::int32_t below = y == 0 ? geometry.height : gaps[Cell{x, y - 1}] + 1;
      gaps[Cell{x, y}] = occupancy.is_free(Cell{x, y}) ? std::min(below, geometry.height) : 0;
    }
  }
  for (int y = geometry.height - 2; y >= 0; --y) {
    for (int x = 0; x < geometry.width; ++x) {
      gaps[Cell{x, y}] = std::min(gaps[Cell{x, y}], gaps[Cell{x, y + 1}] + 1);
    }
  }
  return gaps;
}

// One row of the distance transform [cells²]: the lower envelope of φ(x - i) + g(i)², φ(Δ) = max(0, |Δ| - ½)². φ is convex, so two of
// these curves cross once and a stack of the curves that are somewhere lowest suffices (Felzenszwalb & Huttenlocher 2012, for squares).
class RowEnvelope {
 public:
  void add(int column, double height_squared) {
    const Curve curve{column, height_squared, 0};
    while (!curves_.empty()) {
      const int start = crossing(curves_.back(), curve);
      if (start > curves_.back().start) {
        if (start < width_) curves_.push_back({column, height_squared, start});
        return;
      }
      curves_.pop_back();
    }
    curves_.push_back(curve);
  }

  template <typename Visitor>
  void visit(Visitor visitor) const {
    for (std::size_t i = 0; i < curves_.size(); ++i) {
      const int end = i + 1 < curves_.size() ? curves_[i + 1].start : width_;
      for (int x = curves_[i].start; x < end; ++x) visitor(x, value(curves_[i], x));
    }
  }

  void reset(int width) {
    width_ = width;
    curves_.clear();
  }

 private:
  struct Curve {
    int column;
    double height_squared;
    int start;  // the first column where it is the lowest
  };

  static double value(const Curve& curve, int x) { return squared(std::max(0.0, std::abs(x - curve.column) - 0.5)) + curve.height_squared; }

  // The first column where `right` is lower than `left`.
  int crossing(const Curve& left, const Curve& right) const {
    int low = left.start;
    int high = width_;
    while (low < high) {
      const int middle = low + (high - low) / 2;
      if (value(right, middle) < value(left, middle)) {
        high = middle;
      } else {
        low = middle + 1;
      }
    }
    return low;
  }

  int width_ = 0;
  std::vector<Curve> curves_;
};

double squared_distance(const Eigen::AlignedBox2d& box, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  const Eigen::Vector2d step = to - from;
  const double length_squared = step.squaredNorm();
  // Along a segment the distance to a box is convex: its minimum is at an end, where a corner is nearest, or inside the box.
  double least = std::min(box.squaredExteriorDistance(from), box.squaredExteriorDistance(to));
  if (length_squared == 0.0 || least == 0.0) return least;
  for (const auto corner :
       {Eigen::AlignedBox2d::BottomLeft, Eigen::AlignedBox2d::BottomRight, Eigen::AlignedBox2d::TopLeft, Eigen::AlignedBox2d::TopRight}) {
    const Eigen::Vector2d at = box.corner(corner);
    const double t = std::clamp((at - from).dot(step) / length_squared, 0.0, 1.0);
    least = std::min(least, (from + t * step - at).squaredNorm());
  }
  double enter = 0.0;
  double leave = 1.0;
  for (int axis = 0; axis < 2; ++axis) {
    if (step[axis] == 0.0) {
      if (from[axis] < box.min()[axis] || from[axis] > box.max()[axis]) return least;
      continue;
    }
    const double a = (box.min()[axis] - from[axis]) / step[axis];
    const double b = (box.max()[axis] - from[axis]) / step[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave ? 0.0 : least;
}

}  // namespace

ClearanceMap::ClearanceMap(const OccupancyMap& occupancy)
    : column_gap_(column_gaps(occupancy)), center_distance_(occupancy.geometry(), 0.0f) {
  const GridGeometry& geometry = occupancy.geometry();
  RowEnvelope envelope;
  for (int y = 0; y < geometry.height; ++y) {
    envelope.reset(geometry.width);
    for (int x = 0; x < geometry.width; ++x) {
      const std::int32_t gap = column_gap_[Cell{x, y}];
      if (gap < geometry.height) envelope.add(x, squared(std::max(0.0, gap - 0.5)));
    }
    for (int x = 0; x < geometry.width; ++x) {
      center_distance_[Cell{x, y}] = static_cast<float>(border_distance(geometry.center({x, y})));
    }
    envelope.visit([&](int x, double cells_squared) {
      float& distance = center_distance_[Cell{x, y}];
      distance = std::min(distance, static_cast<float>(geometry.resolution * std::sqrt(cells_squared)));
    });
  }
  for (std::size_t i = 0; i < geometry.size(); ++i) {
    center_distance_[i] = std::max(0.0f, std::nextafter(center_distance_[i], -1.0f));
  }
}

double ClearanceMap::border_distance(const Eigen::Vector2d& point) const {
  const Eigen::Array2d low = (point - geometry().origin).array();
  const Eigen::Array2d high = (geometry().upper_corner() - point).array();
  const double least = std::min(low.minCoeff(), high.minCoeff());
  return least > 0.0 ? least : 0.0;
}

double ClearanceMap::distance(const Eigen::Vector2d& point) const {
  const auto cell = geometry().cell_near(point);
  if (!cell || column_gap_[*cell] == 0) return 0.0;
  const Eigen::Vector2d at = (point - geometry().origin) / geometry().resolution;
  double least = border_distance(point) / geometry().resolution;
  double least_squared = squared(least);
  const auto look_at_column = [&](int x) {
    const double across = outside_unit(at.x(), x);
    const std::int32_t gap = column_gap_[Cell{x, cell->y}];
    // Which of the two rows at that gap is not free does not matter: were the nearer one free, the other would be the nearest by less than
    // a cell.
    for (const int row : {cell->y - gap, cell->y + gap}) {
      if (row < 0 || row >= geometry().height || column_gap_[Cell{x, row}] != 0) continue;
      least_squared = std::min(least_squared, squared(across) + squared(outside_unit(at.y(), row)));
    }
    least = std::sqrt(least_squared);
  };
  look_at_column(cell->x);
  for (int x = cell->x - 1; x >= 0 && outside_unit(at.x(), x) < least; --x) look_at_column(x);
  for (int x = cell->x + 1; x < geometry().width && outside_unit(at.x(), x) < least; ++x) look_at_column(x);
  return geometry().resolution * least;
}

bool ClearanceMap::is_clear(const Eigen::Vector2d& point, double radius) const {
  const auto cell = geometry().cell_near(point);
  if (!cell) return false;
  // The distance changes by no more than the way moved from the centre.
  const double moved = (point - geometry().center(*cell)).norm();
  const double at_center = center_distance_[*cell];
  const double rounding = 1e-6 * (at_center + geometry().resolution);
  if (at_center - moved > radius) return true;
  if (at_center + moved + rounding < radius) return false;
  const double exact = distance(point);
  return exact >= radius && exact > 0.0;
}

bool ClearanceMap::is_clear(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double radius) const {
  if (!is_clear(from, radius) || !is_clear(to, radius)) return false;
  const double length = (to - from).norm();
  const Eigen::Vector2d direction = length > 0.0 ? Eigen::Vector2d((to - from) / length) : Eigen::Vector2d::Zero();
  // Where it is narrow, looked at cell by cell, a piece at a time: as long as the disk is wide, whose surroundings are looked at anyhow.
  const double piece = std::max(geometry().resolution, radius);
  double done = 0.0;
  while (done < length) {
    const Eigen::Vector2d at = from + done * direction;
    const auto cell = geometry().cell_near(at);
    if (!cell) return false;
    const double at_center = center_distance_[*cell];
    const double moved = (at - geometry().center(*cell)).norm();
    const double room = at_center - moved - radius;
    if (room >= geometry().resolution) {
      done += room;
      continue;
    }
    const double next = std::min(length, done + piece);
    if (!is_clear_of_cells(at, next == length ? to : Eigen::Vector2d(from + next * direction), radius)) return false;
    done = next;
  }
  return true;
}

bool ClearanceMap::is_clear_of_cells(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double radius) const {
  const GridGeometry& grid = geometry();
  const Eigen::Array2d low = ((from.cwiseMin(to) - grid.origin).array() - radius) / grid.resolution;
  const Eigen::Array2d high = ((from.cwiseMax(to) - grid.origin).array() + radius) / grid.resolution;
  const int x0 = std::max(0, static_cast<int>(std::floor(low.x())) - 1);
  const int y0 = std::max(0, static_cast<int>(std::floor(low.y())) - 1);
  const int x1 = std::min(grid.width - 1, static_cast<int>(std::floor(high.x())) + 1);
  const int y1 = std::min(grid.height - 1, static_cast<int>(std::floor(high.y())) + 1);
  for (int x = x0; x <= x1; ++x) {
    for (int y = y0, gap = 0; y <= y1; y += std::max(1, gap)) {
      gap = column_gap_[Cell{x, y}];
      if (gap != 0) continue;
      const double distance_squared = squared_distance({grid.corner({x, y}), grid.corner({x + 1, y + 1})}, from, to);
      if (distance_squared < squared(radius) || distance_squared == 0.0) return false;
    }
  }
  return true;
}

}  // namespace alignability
