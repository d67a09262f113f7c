// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/segment_shape.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>

namespace alignability::detail {

std::vector<std::vector<std::int32_t>> members_of(const std::vector<int>& segment_of_point, int segments) {
  std::vector<std::vector<std::int32_t>> members(static_cast<std::size_t>(segments));
  for (std::size_t i = 0; i < segment_of_point.size(); ++i) {
    if (segment_of_point[i] >= 0) members[static_cast<std::size_t>(segment_of_point[i])].push_back(static_cast<std::int32_t>(i));
  }
  return members;
}

SegmentShape shape_of(const Scan& scan, std::span<const std::int32_t> members) {
  SegmentShape shape;
  shape.center.setZero();
  for (const std::int32_t i : members) shape.center += scan.points[static_cast<std::size_t>(i)].cast<double>();
  shape.center /= static_cast<double>(members.size());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const std::int32_t i : members) {
    const Eigen::Vector3d from_center = scan.points[static_cast<std::size_t>(i)].cast<double>() - shape.center;
    covariance += from_center * from_center.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance / static_cast<double>(members.size()));
  shape.axes = solver.eigenvectors();
  shape.eigenvalues = solver.eigenvalues();
  Eigen::Array3d low = Eigen::Array3d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Array3d high = -low;
  for (const std::int32_t i : members) {
    const Eigen::Array3d along =
        (shape.axes.transpose() * (scan.points[static_cast<std::size_t>(i)].cast<double>() - shape.center)).array();
    low = low.min(along);
    high = high.max(along);
  }
  shape.extents = high - low;
  return shape;
}

double SegmentShape::flatness() const { return eigenvalues[2] > 0.0 ? std::max(0.0, eigenvalues[0]) / eigenvalues[2] : 0.0; }

double SegmentShape::area() const {
  const Eigen::Array3d products(extents[0] * extents[1], extents[1] * extents[2], extents[2] * extents[0]);
  return products.maxCoeff();
}

}  // namespace alignability::detail
