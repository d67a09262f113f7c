// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>

#include "costmap/clearance_map.hpp"

namespace alignability {
namespace {

constexpr double kBrush = 1e-9;  // [cells]

struct Interval {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void extend(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

// The first and the last cell that an interval [cells] reaches into by more than a brush; of an interval without length, the cell that
// holds it, if it lies on no line between two.
std::pair<int, int> cells_of(const Interval& interval) {
  return {static_cast<int>(std::floor(interval.low + kBrush)), static_cast<int>(std::ceil(interval.high - kBrush)) - 1};
}

}  // namespace

bool ClearanceMap::is_clear(std::span<const Eigen::Vector2d> hull, double margin) const {
  const double grown = margin / geometry().resolution;
  const auto in_cells = [&](const Eigen::Vector2d& point) { return Eigen::Vector2d((point - geometry().origin) / geometry().resolution); };
  Interval height;
  Interval width;
  for (const Eigen::Vector2d& point : hull) {
    const Eigen::Vector2d at = in_cells(point);
    width.extend(at.x());
    height.extend(at.y());
  }
  const Interval map_width{grown, geometry().width - grown};
  const Interval map_height{grown, geometry().height - grown};
  // NaN fails the comparisons.
  if (!(width.low >= map_width.low - kBrush && width.high <= map_width.high + kBrush)) return false;
  if (!(height.low >= map_height.low - kBrush && height.high <= map_height.high + kBrush)) return false;

  const auto [first_row, last_row] = cells_of({height.low - grown, height.high + grown});
  for (int row = first_row; row <= last_row; ++row) {
    // Where the hull, grown, crosses the row: the hull's extent within the row grown. The lines between all pairs of points have the
    // same extent as its outline.
    const double low = row - grown;
    const double high = row + 1.0 + grown;
    Interval reach;
    for (std::size_t i = 0; i < hull.size(); ++i) {
      const Eigen::Vector2d a = in_cells(hull[i]);
      if (a.y() >= low && a.y() <= high) reach.extend(a.x());
      for (std::size_t j = i + 1; j < hull.size(); ++j) {
        const Eigen::Vector2d b = in_cells(hull[j]);
        for (const double y : {low, high}) {
          if ((a.y() < y) != (b.y() < y)) reach.extend(a.x() + (b.x() - a.x()) * (y - a.y()) / (b.y() - a.y()));
        }
      }
    }
    const auto [first_column, last_column] = cells_of({reach.low - grown, reach.high + grown});
    for (int column = first_column; column <= last_column; ++column) {
      if (!is_free({column, row})) return false;
    }
  }
  return true;
}

}  // namespace alignability
