// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/segment_shape.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>

namespace alignability::detail {
namespace {

Eigen::Vector3d center_of(const Scan& scan, std::span<const std::int32_t> members) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const std::int32_t i : members) sum += scan.points[static_cast<std::size_t>(i)].cast<double>();
  return sum / static_cast<double>(members.size());
}

Eigen::Matrix3d covariance_of(const Scan& scan, std::span<const std::int32_t> members, const Eigen::Vector3d& center) {
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const std::int32_t i : members) {
    const Eigen::Vector3d from_center = scan.points[static_cast<std::size_t>(i)].cast<double>() - center;
    covariance += from_center * from_center.transpose();
  }
  return covariance / static_cast<double>(members.size());
}

Eigen::Vector3d extents_of(const Scan& scan, std::span<const std::int32_t> members, const SegmentShape& shape) {
  Eigen::Array3d low = Eigen::Array3d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Array3d high = -low;
  for (const std::int32_t i : members) {
    const Eigen::Array3d along =
        (shape.axes.transpose() * (scan.points[static_cast<std::size_t>(i)].cast<double>() - shape.center)).array();
    low = low.min(along);
    high = high.max(along);
  }
  return high - low;
}

}  // namespace

std::vector<std::vector<std::int32_t>> members_of(const std::vector<int>& segment_of_point, int segments) {
  std::vector<std::vector<std::int32_t>> members(static_cast<std::size_t>(segments));
  for (std::size_t i = 0; i < segment_of_point.size(); ++i) {
    if (segment_of_point[i] >= 0) members[static_cast<std::size_t>(segment_of_point[i])].push_back(static_cast<std::int32_t>(i));
  }
  return members;
}

SegmentShape shape_of(const Scan& scan, std::span<const std::int32_t> members) {
  SegmentShape shape;
  shape.center = center_of(scan, members);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance_of(scan, members, shape.center));
  shape.axes = solver.eigenvectors();
  shape.eigenvalues = solver.eigenvalues();
  shape.extents = extents_of(scan, members, shape);
  return shape;
}

SegmentShape line_shape_of(const Scan& scan, std::span<const std::int32_t> members) {
  SegmentShape shape;
  shape.center = center_of(scan, members);
  const Eigen::Matrix3d covariance = covariance_of(scan, members, shape.center);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(Eigen::Matrix2d(covariance.topLeftCorner<2, 2>()));
  shape.axes.setIdentity();
  shape.axes.topLeftCorner<2, 2>() = solver.eigenvectors();
  shape.eigenvalues << solver.eigenvalues(), 0.0;
  shape.extents = extents_of(scan, members, shape);
  shape.extents.z() = 0.0;
  return shape;
}

double SegmentShape::flatness() const { return eigenvalues[2] > 0.0 ? std::max(0.0, eigenvalues[0]) / eigenvalues[2] : 0.0; }

double SegmentShape::straightness() const { return eigenvalues[1] > 0.0 ? std::max(0.0, eigenvalues[0]) / eigenvalues[1] : 0.0; }

double SegmentShape::area() const {
  const Eigen::Array3d products(extents[0] * extents[1], extents[1] * extents[2], extents[2] * extents[0]);
  return products.maxCoeff();
}

}  // namespace alignability::detail
