// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/view.hpp"

#include <algorithm>
#include <cmath>

namespace alignability::detail {
namespace {

constexpr double kLargestCell = 120.0;
const Eigen::Vector2d kSmallestFrame(520.0, 340.0);
// Cairo computes in 24.8 fixed point.
constexpr double kFarthestPixel = 1e5;

WorldBox box_around(const GridGeometry& a, const GridGeometry& b) {
  if (a.size() == 0) return {b.origin, b.upper_corner()};
  if (b.size() == 0) return {a.origin, a.upper_corner()};
  return {a.origin.cwiseMin(b.origin), a.upper_corner().cwiseMax(b.upper_corner())};
}

double whole_pixels(double scale, double cell) {
  const double pixels = scale * cell;
  return pixels < 1.0 ? scale : std::round(pixels) / cell;
}

}  // namespace

Eigen::Vector2d View::to_pixel(const Eigen::Vector2d& point) const {
  const Eigen::Vector2d at = scale * (point - lower);
  return Eigen::Vector2d(frame.left + at.x(), frame.bottom() - at.y()).cwiseMax(-kFarthestPixel).cwiseMin(kFarthestPixel);
}

Rectangle View::to_pixels(const WorldBox& box) const {
  const Eigen::Vector2d corner = to_pixel({box.lower.x(), box.upper.y()});
  const Eigen::Vector2d size = scale * box.extent();
  return {corner.x(), corner.y(), size.x(), size.y()};
}

View view_of(const WorldBox& box, double scale) {
  const Eigen::Vector2d pixels = (scale * box.extent()).array().round();
  const Eigen::Vector2d size = pixels.cwiseMax(kSmallestFrame);
  // Half of it rounded, so that cells stay on whole pixels.
  const Eigen::Vector2d margin = (0.5 * (size - pixels)).array().floor();
  return {{0.0, 0.0, size.x(), size.y()}, scale, box.lower - margin / scale};
}

View view_of(const GridGeometry& cells, const OccupancyMap& occupancy) {
  const WorldBox box = box_around(cells, occupancy.geometry());
  const double side = std::max(box.extent().maxCoeff(), cells.resolution);
  const double cell = occupancy.geometry().size() == 0 ? cells.resolution : occupancy.geometry().resolution;
  return view_of(box, whole_pixels(std::min(kLongSide / side, kLargestCell / cells.resolution), cell));
}

}  // namespace alignability::detail
