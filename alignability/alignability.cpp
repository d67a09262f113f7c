// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/alignability.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>
#include <sstream>

#include "core/range.hpp"

namespace alignability {
namespace {

using Solver = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>;
using Members = std::vector<std::size_t>;

std::vector<Members> members_of(const Segmentation& segmentation) {
  std::vector<Members> members(static_cast<std::size_t>(segmentation.segments));
  for (std::size_t i = 0; i < segmentation.segment_of_point.size(); ++i) {
    const int segment = segmentation.segment_of_point[i];
    if (segment >= 0) members[static_cast<std::size_t>(segment)].push_back(i);
  }
  return members;
}

// The principal axes of a segment's points, and how the points spread along them.
class SegmentShape {
 public:
  SegmentShape(const Scan& scan, const Members& members) {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const std::size_t i : members) mean += scan.points[i].cast<double>();
    mean /= static_cast<double>(members.size());
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (const std::size_t i : members) {
      const Eigen::Vector3d from_mean = scan.points[i].cast<double>() - mean;
      covariance += from_mean * from_mean.transpose();
    }
    const Solver solver(covariance / static_cast<double>(members.size()));
    eigenvalues_ = solver.eigenvalues();
    Eigen::Array3d low = Eigen::Array3d::Constant(std::numeric_limits<double>::infinity());
    Eigen::Array3d high = -low;
    for (const std::size_t i : members) {
      const Eigen::Array3d along = (solver.eigenvectors().transpose() * (scan.points[i].cast<double>() - mean)).array();
      low = low.min(along);
      high = high.max(along);
    }
    extents_ = high - low;
  }

  // λ_s/λ_l; 0 for points that are all one.
  double flatness() const { return eigenvalues_[2] > 0.0 ? std::max(0.0, eigenvalues_[0]) / eigenvalues_[2] : 0.0; }
  // The two largest extents of the oriented bounding box, multiplied.
  double area() const {
    const Eigen::Array3d products(extents_[0] * extents_[1], extents_[1] * extents_[2], extents_[2] * extents_[0]);
    return products.maxCoeff();
  }

 private:
  Eigen::Vector3d eigenvalues_;  // ascending
  Eigen::Array3d extents_;
};

void set_moment(Alignability& result, const std::vector<Eigen::Vector3d>& normals, Moment moment) {
  if (normals.empty()) return;
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  if (moment == Moment::about_mean) {
    for (const Eigen::Vector3d& normal : normals) center += normal;
    center /= static_cast<double>(normals.size());
  }
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& normal : normals) sum += (normal - center) * (normal - center).transpose();
  const Solver solver(sum / static_cast<double>(normals.size()));
  result.eigenvalues = solver.eigenvalues().reverse().cwiseMax(0.0);
  result.weakest_direction = solver.eigenvectors().col(0);
  if (result.eigenvalues[0] > 0.0) result.alpha = std::clamp(result.eigenvalues[2] / result.eigenvalues[0], 0.0, 1.0);
}

}  // namespace

ScoredScan score(const Scan& scan, const AlignabilityOptions& options) {
  const Segmentation segmentation = segment_with_pcl(scan, options.segmentation);
  ScoredScan scored;
  scored.plane_of_point.assign(scan.points.size(), -1);
  Alignability& result = scored.alignability;
  result.points = segmentation.points;
  std::vector<Eigen::Vector3d> normals;
  for (const Members& members : members_of(segmentation)) {
    const SegmentShape shape(scan, members);
    if (!(shape.flatness() < options.plane_threshold)) continue;
    ++result.planes_found;
    if (!(shape.area() > options.min_area)) continue;
    for (const std::size_t i : members) {
      scored.plane_of_point[i] = result.planes_kept;
      if (segmentation.normals[i].allFinite()) normals.push_back(segmentation.normals[i].cast<double>());
    }
    ++result.planes_kept;
  }
  set_moment(result, normals, options.moment);
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
