// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/merged_planes.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <functional>

#include "core/pose.hpp"

namespace alignability::detail {
namespace {

using Members = std::vector<std::int32_t>;

const double kAlike = std::cos(radians(30.0));
constexpr double kOffPlane = 0.05;   // [m]
constexpr double kNoiseWidth = 8.0;  // σ that a few hundred returns from one line spread over, at most
constexpr double kStripWidth = 3.0;  // σ: three times as wide in the mean, a plane is held across as noise would not hold it

Eigen::Vector3d principal_axis(const std::vector<Eigen::Vector3d>& normals) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& normal : normals) sum += normal * normal.transpose();
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(sum).eigenvectors().col(2);
}

MergedPlane plane_of(const Scan& scan, Members members, std::span<const Eigen::Vector3f> normals, Dimensions dimensions,
                     double range_stddev) {
  MergedPlane plane{.members = std::move(members), .normals = {}, .shape = {}, .own_normal = {}, .viewpoint = {}};
  for (const std::int32_t i : plane.members) {
    const Eigen::Vector3f& normal = normals[static_cast<std::size_t>(i)];
    if (normal.allFinite()) plane.normals.push_back(normal.cast<double>());
  }
  plane.shape = dimensions == Dimensions::two ? line_shape_of(scan, plane.members) : shape_of(scan, plane.members);
  plane.viewpoint = viewpoint(scan, static_cast<std::size_t>(plane.members.front()));
  plane.is_strip = std::sqrt(std::max(0.0, plane.shape.eigenvalues[1])) <= kStripWidth * range_stddev;
  const bool is_narrow = plane.shape.extents[1] <= kNoiseWidth * range_stddev;
  plane.own_normal = is_narrow ? principal_axis(plane.normals) : plane.shape.axes.col(0);
  if (plane.own_normal.dot(plane.shape.center - plane.viewpoint) > 0.0) plane.own_normal = -plane.own_normal;
  return plane;
}

bool holds(const MergedPlane& plane, const MergedPlane& segment) {
  return std::abs(plane.own_normal.dot(segment.own_normal)) >= kAlike &&
         std::abs(plane.own_normal.dot(segment.shape.center - plane.shape.center)) <= kOffPlane;
}

}  // namespace

std::vector<MergedPlane> merged_planes(const Scan& scan, std::vector<Members> segments, std::span<const Eigen::Vector3f> normals,
                                       Dimensions dimensions, double range_stddev) {
  std::ranges::stable_sort(segments, std::ranges::greater{}, &Members::size);
  std::vector<MergedPlane> seeds;  // each the largest segment of its plane
  std::vector<Members> joined;     // what else lies in it
  for (Members& members : segments) {
    MergedPlane segment = plane_of(scan, std::move(members), normals, dimensions, range_stddev);
    const auto seed = std::ranges::find_if(seeds, [&](const MergedPlane& plane) { return holds(plane, segment); });
    if (seed == seeds.end()) {
      seeds.push_back(std::move(segment));
      joined.emplace_back();
    } else {
      Members& others = joined[static_cast<std::size_t>(seed - seeds.begin())];
      others.insert(others.end(), segment.members.begin(), segment.members.end());
      ++seed->segments;
    }
  }
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    if (joined[i].empty()) continue;
    Members all = std::move(seeds[i].members);
    all.insert(all.end(), joined[i].begin(), joined[i].end());
    const int count = seeds[i].segments;
    seeds[i] = plane_of(scan, std::move(all), normals, dimensions, range_stddev);
    seeds[i].segments = count;
  }
  std::ranges::stable_sort(seeds, std::ranges::greater{}, &MergedPlane::count);
  return seeds;
}

}  // namespace alignability::detail
