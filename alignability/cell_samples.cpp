// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/cell_samples.hpp"

#include <algorithm>

namespace alignability {
namespace {

// The occupancy cells along one axis that an interval [low, high] overlaps, cut to the map.
struct Span {
  int first;
  int last;  // inclusive
};

Span overlapped(double low, double high, double origin, double resolution, int cells) {
  const double first = std::floor((low - origin) / resolution);
  const double last = std::ceil((high - origin) / resolution) - 1.0;
  return {static_cast<int>(std::clamp(first, 0.0, static_cast<double>(cells))), static_cast<int>(std::clamp(last, -1.0, cells - 1.0))};
}

}  // namespace

FreePart::FreePart(const OccupancyMap& occupancy, const GridGeometry& map, Cell cell, const EvaluationRule& rule) {
  const GridGeometry& fine = occupancy.geometry();
  const Eigen::Vector2d low = map.corner(cell);
  const Eigen::Vector2d high = map.corner({cell.x + 1, cell.y + 1});
  const Span columns = overlapped(low.x(), high.x(), fine.origin.x(), fine.resolution, fine.width);
  const Span rows = overlapped(low.y(), high.y(), fine.origin.y(), fine.resolution, fine.height);
  for (int y = rows.first; y <= rows.last; ++y) {
    for (int x = columns.first; x <= columns.last; ++x) {
      const auto probability = occupancy.occupancy({x, y});
      if (!probability || *probability > rule.occupied_above) continue;
      const Eigen::Vector2d piece_low = fine.corner({x, y}).cwiseMax(low);
      const Eigen::Vector2d size = fine.corner({x + 1, y + 1}).cwiseMin(high) - piece_low;
      if (size.minCoeff() <= 1e-9 * fine.resolution) continue;
      pieces_.push_back({piece_low, size, area_});
      area_ += size.prod();
    }
  }
  const double whole = map.resolution * map.resolution;
  constexpr double kRounding = 1e-9;
  evaluated_ = area_ > 0.0 && (whole - area_) <= (rule.max_occupied_share + kRounding) * whole;
}

Eigen::Vector2d FreePart::at(double share, double u, double v) const {
  const double wanted = share * area_;
  const auto after = std::ranges::upper_bound(pieces_, wanted, {}, &Piece::area_before);
  const Piece& piece = *std::prev(after);
  return piece.low + Eigen::Vector2d(u * piece.size.x(), v * piece.size.y());
}

}  // namespace alignability
