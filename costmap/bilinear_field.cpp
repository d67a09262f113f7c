// SPDX-License-Identifier: BSD-3-Clause
#include "costmap/bilinear_field.hpp"

#include <tuple>

namespace alignability {

double BilinearField::at(const Eigen::Vector2d& point) const {
  const GridGeometry& grid = nodes_.geometry();
  const Eigen::Array2d patch = ((point - grid.origin) / grid.resolution - Eigen::Vector2d::Constant(0.5)).array().floor();
  const auto clamped = [](double index, int nodes) { return index >= -1.0 ? static_cast<int>(std::min(index, nodes - 1.0)) : -1; };
  return in_patch({clamped(patch.x(), grid.width), clamped(patch.y(), grid.height)}, point);
}

double BilinearField::integral(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const {
  if (std::tie(to.x(), to.y()) < std::tie(from.x(), from.y())) return integral(to, from);
  const GridGeometry& grid = nodes_.geometry();
  const Eigen::Vector2d half = Eigen::Vector2d::Constant(0.5);
  // In cells, from the lowest centre on.
  const Eigen::Vector2d a = (from - grid.origin) / grid.resolution - half;
  const Eigen::Vector2d b = (to - grid.origin) / grid.resolution - half;
  const Eigen::Vector2d step = b - a;
  const double twelfth = step.x() * step.y() / 12.0;
  double mean = 0.0;
  detail::traverse_unit_cells(a, b, grid.width - 1, grid.height - 1, [&](Cell patch, double begin, double end) {
    const double share = end - begin;
    const Corners corner = corners_of(patch);
    const Eigen::Vector2d middle = a + 0.5 * (begin + end) * step;
    const double x = std::clamp(middle.x() - std::max(patch.x, 0), 0.0, 1.0);
    const double y = std::clamp(middle.y() - std::max(patch.y, 0), 0.0, 1.0);
    const double below = corner.low_left + x * (corner.low_right - corner.low_left);
    const double above = corner.high_left + x * (corner.high_right - corner.high_left);
    // Along the piece the field is quadratic: its mean is the value in the middle and a twelfth of the second-order term.
    const double twist = corner.low_left - corner.low_right - corner.high_left + corner.high_right;
    mean += share * (below + y * (above - below) + twist * twelfth * share * share);
  });
  return (to - from).norm() * mean;
}

double BilinearField::integral(const Arc& arc) const {
  double sum = 0.0;
  visit(arc, [&](const BilinearAlongArc& piece) { sum += piece.length * piece.mean(); });
  return sum;
}

BilinearAlongArc BilinearField::along(const Arc& arc, Cell patch, double begin, double end) const {
  const Pose2 middle = arc.at(0.5 * (begin + end) * arc.length());
  const double sense = std::copysign(1.0, arc.travel);
  const Corners corner = corners_of(patch);
  const GridGeometry& grid = nodes_.geometry();
  const Cell low{std::max(patch.x, 0), std::max(patch.y, 0)};
  const Eigen::Array2d at = ((middle.position() - grid.center(low)) / grid.resolution).array().cwiseMax(0.0).cwiseMin(1.0);
  const double right = corner.low_right - corner.low_left;
  const double up = corner.high_left - corner.low_left;
  const double twist = corner.low_left - corner.low_right - corner.high_left + corner.high_right;
  BilinearAlongArc along;
  along.length = (end - begin) * arc.length();
  along.curvature = sense * arc.curvature;
  along.direction = sense * Eigen::Vector2d(std::cos(middle.yaw), std::sin(middle.yaw));
  along.value = in_patch(patch, middle.position());
  along.gradient = Eigen::Vector2d(right + at.y() * twist, up + at.x() * twist) / grid.resolution;
  along.twist = twist / (grid.resolution * grid.resolution);
  return along;
}

}  // namespace alignability
