// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/alignability.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <sstream>

#include "alignability/segment_shape.hpp"
#include "core/range.hpp"

namespace alignability {
namespace {

void set_moment(ScoredScan& scored, const std::vector<Eigen::Vector3d>& normals, Moment moment) {
  if (normals.empty()) return;
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  if (moment == Moment::about_mean) {
    for (const Eigen::Vector3d& normal : normals) center += normal;
    center /= static_cast<double>(normals.size());
  }
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& normal : normals) sum += (normal - center) * (normal - center).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(sum / static_cast<double>(normals.size()));
  Alignability& result = scored.alignability;
  scored.axes = solver.eigenvectors().rowwise().reverse();
  result.eigenvalues = solver.eigenvalues().reverse().cwiseMax(0.0);
  result.weakest_direction = solver.eigenvectors().col(0);
  if (result.eigenvalues[0] > 0.0) result.alpha = std::clamp(result.eigenvalues[2] / result.eigenvalues[0], 0.0, 1.0);
}

}  // namespace

ScoredScan score(const Scan& scan, const AlignabilityOptions& options) {
  Segmentation segmentation = segment_with_pcl(scan, options.segmentation);
  ScoredScan scored;
  scored.plane_of_point.assign(scan.points.size(), -1);
  Alignability& result = scored.alignability;
  result.points = segmentation.points;
  std::vector<Eigen::Vector3d> normals;
  for (const auto& members : detail::members_of(segmentation.segment_of_point, segmentation.segments)) {
    const detail::SegmentShape shape = detail::shape_of(scan, members);
    if (!(shape.flatness() < options.plane_threshold)) continue;
    ++result.planes_found;
    if (!(shape.area() > options.min_area)) continue;
    for (const std::size_t i : members) {
      scored.plane_of_point[i] = result.planes_kept;
      if (segmentation.normals[i].allFinite()) normals.push_back(segmentation.normals[i].cast<double>());
    }
    ++result.planes_kept;
  }
  set_moment(scored, normals, options.moment);
  scored.normals = std::move(segmentation.normals);
  return scored;
}

std::string to_yaml(const AlignabilityOptions& options) {
  std::ostringstream out;
  out << "engine: pcl\n"
      << "min_range: " << to_text(options.segmentation.range_min) << '\n'
      << "normal_neighbours: " << options.segmentation.normal_neighbours << '\n'
      << "growing_neighbours: " << options.segmentation.growing_neighbours << '\n'
      << "smoothness_deg: " << to_text(degrees(options.segmentation.smoothness)) << '\n'
      << "curvature: " << to_text(options.segmentation.curvature) << '\n'
      << "min_points: " << options.segmentation.min_points << '\n'
      << "plane_threshold: " << to_text(options.plane_threshold) << '\n'
      << "min_area: " << to_text(options.min_area) << '\n'
      << "centred: " << (options.moment == Moment::about_mean ? "true" : "false") << '\n';
  return out.str();
}

}  // namespace alignability
