// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/explanation.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "alignability/merged_planes.hpp"
#include "alignability/segment_shape.hpp"
#include "core/pose.hpp"

namespace alignability {
namespace {

using detail::MergedPlane;

const double kUpright = std::cos(radians(30.0));

PlaneKind kind_of(const Eigen::Vector3d& normal) {
  if (normal.z() >= kUpright) return PlaneKind::floor;
  if (normal.z() <= -kUpright) return PlaneKind::ceiling;
  return normal.head<2>().norm() >= kUpright ? PlaneKind::wall : PlaneKind::slope;
}

// Column by column; the sign of an axis means nothing.
Eigen::Matrix3d with_largest_positive(Eigen::Matrix3d axes) {
  for (int i = 0; i < 3; ++i) {
    Eigen::Index largest = 0;
    axes.col(i).cwiseAbs().maxCoeff(&largest);
    if (axes(largest, i) < 0.0) axes.col(i) *= -1.0;
  }
  return axes;
}

// Along one axis: what each plane's normals add to the second moment, and what they would if none leaned off its plane.
struct Sums {
  std::vector<double> as_they_are;
  double flat = 0.0;

  double total() const { return std::accumulate(as_they_are.begin(), as_they_are.end(), 0.0); }
};

Sums sums_along(const Eigen::Vector3d& axis, const std::vector<MergedPlane>& parts, Moment moment) {
  double center = 0.0;
  double flat_center = 0.0;
  if (moment == Moment::about_mean) {
    double count = 0.0;
    for (const MergedPlane& part : parts) {
      for (const Eigen::Vector3d& normal : part.normals) center += normal.dot(axis);
      flat_center += part.count() * part.own_normal.dot(axis);
      count += part.count();
    }
    center /= count;
    flat_center /= count;
  }
  const auto squared = [](double value) { return value * value; };
  Sums sums;
  for (const MergedPlane& part : parts) {
    double sum = 0.0;
    for (const Eigen::Vector3d& normal : part.normals) sum += squared(normal.dot(axis) - center);
    sums.as_they_are.push_back(sum);
    sums.flat += part.count() * squared(part.own_normal.dot(axis) - flat_center);
  }
  return sums;
}

ExplainedPlane explained(const MergedPlane& part, const Eigen::Matrix3d& R_map_scan, double normals) {
  ExplainedPlane plane;
  plane.normal = R_map_scan * part.own_normal;
  plane.kind = kind_of(plane.normal);
  plane.segments = part.segments;
  plane.points = part.normals.size();
  plane.share = part.count() / normals;
  plane.distance = std::abs(part.own_normal.dot(part.shape.center - part.viewpoint));
  plane.extents = part.shape.extents;
  std::ranges::sort(plane.extents, std::ranges::greater{});
  return plane;
}

}  // namespace

Explanation explain(const Scan& scan, const Eigen::Matrix3d& R_map_scan, double range_stddev, const AlignabilityOptions& options) {
  const ScoredScan scored = score(scan, options);
  Explanation explanation;
  explanation.alignability = scored.alignability;
  explanation.axes = with_largest_positive(R_map_scan * scored.axes);
  explanation.plane_of_point.assign(scan.points.size(), -1);
  const std::vector<MergedPlane> parts =
      detail::merged_planes(scan, detail::members_of(scored.plane_of_point, scored.alignability.planes_kept), scored.normals,
                            scored.alignability.dimensions == 2 ? Dimensions::two : Dimensions::three, range_stddev);
  double normals = 0.0;
  for (std::size_t plane = 0; plane < parts.size(); ++plane) {
    normals += parts[plane].count();
    for (const std::int32_t i : parts[plane].members) explanation.plane_of_point[static_cast<std::size_t>(i)] = static_cast<int>(plane);
  }
  const Sums sums = sums_along(scored.alignability.weakest_direction, parts, options.moment);
  const double total = sums.total();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    ExplainedPlane plane = explained(parts[i], R_map_scan, normals);
    if (total > 0.0) plane.holds = sums.as_they_are[i] / total;
    explanation.planes.push_back(plane);
  }
  if (total > 0.0) explanation.noise = std::max(0.0, 1.0 - sums.flat / total);
  return explanation;
}

}  // namespace alignability
