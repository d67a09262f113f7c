// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/explanation.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "alignability/segment_shape.hpp"
#include "core/pose.hpp"

namespace alignability {
namespace {

using Members = std::vector<std::int32_t>;

const double kUpright = std::cos(radians(30.0));
constexpr double kOffPlane = 0.05;   // [m]
constexpr double kNoiseWidth = 8.0;  // σ that a few hundred returns from one line spread over, at most

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

std::vector<Eigen::Vector3d> normals_of(const ScoredScan& scored, const Members& members) {
  std::vector<Eigen::Vector3d> normals;
  for (const std::int32_t i : members) {
    const Eigen::Vector3f& normal = scored.normals[static_cast<std::size_t>(i)];
    if (normal.allFinite()) normals.push_back(normal.cast<double>());
  }
  return normals;
}

Eigen::Vector3d principal_axis(const std::vector<Eigen::Vector3d>& normals) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& normal : normals) sum += normal * normal.transpose();
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(sum).eigenvectors().col(2);
}

// A plane on the way to its explanation, in the `lidar` frame.
struct Part {
  Part(const Scan& scan, const ScoredScan& scored, Members points, double range_stddev)
      : members(std::move(points)), normals(normals_of(scored, members)), shape(detail::shape_of(scan, members)) {
    const bool is_strip = shape.extents[1] <= kNoiseWidth * range_stddev;
    own_normal = is_strip ? principal_axis(normals) : shape.axes.col(0);
    if (own_normal.dot(shape.center) > 0.0) own_normal = -own_normal;
  }

  bool holds_in_its_plane(const Part& other) const {
    return std::abs(own_normal.dot(other.own_normal)) >= kUpright &&
           std::abs(own_normal.dot(other.shape.center - shape.center)) <= kOffPlane;
  }
  double count() const { return static_cast<double>(normals.size()); }

  Members members;
  std::vector<Eigen::Vector3d> normals;
  detail::SegmentShape shape;
  Eigen::Vector3d own_normal;
  int segments = 1;
};

// The largest segments first, each takes in those that lie in its plane; then by points, the most first.
std::vector<Part> planes_of(const Scan& scan, const ScoredScan& scored, double range_stddev) {
  std::vector<Part> seeds;
  std::vector<Members> segments = detail::members_of(scored.plane_of_point, scored.alignability.planes_kept);
  std::ranges::stable_sort(segments, std::ranges::greater{}, &Members::size);
  std::vector<std::pair<Members, int>> planes;
  for (const Members& members : segments) {
    const Part segment(scan, scored, members, range_stddev);
    const auto seed = std::ranges::find_if(seeds, [&](const Part& part) { return part.holds_in_its_plane(segment); });
    if (seed == seeds.end()) {
      seeds.push_back(segment);
      planes.emplace_back(members, 1);
    } else {
      auto& [all, count] = planes[static_cast<std::size_t>(seed - seeds.begin())];
      all.insert(all.end(), members.begin(), members.end());
      ++count;
    }
  }
  std::vector<Part> parts;
  for (auto& [members, count] : planes) {
    parts.emplace_back(scan, scored, std::move(members), range_stddev);
    parts.back().segments = count;
  }
  std::ranges::stable_sort(parts, std::ranges::greater{}, &Part::count);
  return parts;
}

// Along one axis: what each plane's normals add to the second moment, and what they would if none leaned off its plane.
struct Sums {
  std::vector<double> as_they_are;
  double flat = 0.0;

  double total() const { return std::accumulate(as_they_are.begin(), as_they_are.end(), 0.0); }
};

Sums sums_along(const Eigen::Vector3d& axis, const std::vector<Part>& parts, Moment moment) {
  double center = 0.0;
  double flat_center = 0.0;
  if (moment == Moment::about_mean) {
    double count = 0.0;
    for (const Part& part : parts) {
      for (const Eigen::Vector3d& normal : part.normals) center += normal.dot(axis);
      flat_center += part.count() * part.own_normal.dot(axis);
      count += part.count();
    }
    center /= count;
    flat_center /= count;
  }
  const auto squared = [](double value) { return value * value; };
  Sums sums;
  for (const Part& part : parts) {
    double sum = 0.0;
    for (const Eigen::Vector3d& normal : part.normals) sum += squared(normal.dot(axis) - center);
    sums.as_they_are.push_back(sum);
    sums.flat += part.count() * squared(part.own_normal.dot(axis) - flat_center);
  }
  return sums;
}

ExplainedPlane explained(const Part& part, const Eigen::Matrix3d& R_map_lidar, double normals) {
  ExplainedPlane plane;
  plane.normal = R_map_lidar * part.own_normal;
  plane.kind = kind_of(plane.normal);
  plane.segments = part.segments;
  plane.points = part.normals.size();
  plane.share = part.count() / normals;
  plane.distance = std::abs(part.own_normal.dot(part.shape.center));
  plane.extents = part.shape.extents;
  std::ranges::sort(plane.extents, std::ranges::greater{});
  return plane;
}

}  // namespace

Explanation explain(const Scan& scan, const Eigen::Matrix3d& R_map_lidar, double range_stddev, const AlignabilityOptions& options) {
  const ScoredScan scored = score(scan, options);
  Explanation explanation;
  explanation.alignability = scored.alignability;
  explanation.axes = with_largest_positive(R_map_lidar * scored.axes);
  explanation.plane_of_point.assign(scan.points.size(), -1);
  const std::vector<Part> parts = planes_of(scan, scored, range_stddev);
  double normals = 0.0;
  for (std::size_t plane = 0; plane < parts.size(); ++plane) {
    normals += parts[plane].count();
    for (const std::int32_t i : parts[plane].members) explanation.plane_of_point[static_cast<std::size_t>(i)] = static_cast<int>(plane);
  }
  const Sums sums = sums_along(scored.alignability.weakest_direction, parts, options.moment);
  const double total = sums.total();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    ExplainedPlane plane = explained(parts[i], R_map_lidar, normals);
    if (total > 0.0) plane.holds = sums.as_they_are[i] / total;
    explanation.planes.push_back(plane);
  }
  if (total > 0.0) explanation.noise = std::max(0.0, 1.0 - sums.flat / total);
  return explanation;
}

}  // namespace alignability
