// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/information.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>

namespace alignability::detail {
namespace {

// What rounding leaves of an eigenvalue that is 0, as a share of the largest.
constexpr double kRounding = 1e-12;

}  // namespace

PlanarInformation planar_information(std::span<const MergedPlane> planes, const Eigen::Isometry3d& T_base_scan, double stddev,
                                     int points_a_vote) {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  for (const MergedPlane& plane : planes) {
    if (plane.is_strip) continue;
    const Eigen::Vector3d normal = T_base_scan.linear() * plane.own_normal;
    const Eigen::Vector3d center = T_base_scan * plane.shape.center;
    const Eigen::Matrix3d axes = T_base_scan.linear() * plane.shape.axes;
    // (p × n)_z is linear in p: its mean and variance come from those of the points.
    const Eigen::Vector3d along(normal.y(), -normal.x(), 0.0);
    const double lever = center.dot(along);
    const double variance = (axes.transpose() * along).cwiseAbs2().dot(plane.shape.eigenvalues.cwiseMax(0.0));
    const Eigen::Vector3d mean(normal.x(), normal.y(), lever);
    matrix += plane.count() * mean * mean.transpose();
    matrix(2, 2) += plane.count() * variance;
  }
  return marginal_information(points_a_vote * matrix / (stddev * stddev));
}

PlanarInformation marginal_information(const Eigen::Matrix3d& matrix) {
  PlanarInformation information;
  information.matrix = matrix;
  const Eigen::Matrix2d place = matrix.topLeftCorner<2, 2>();
  const Eigen::Vector2d shared = matrix.topRightCorner<2, 1>();
  const double yaw = matrix(2, 2);
  const Eigen::Matrix2d held = yaw > 0.0 ? Eigen::Matrix2d(place - shared * shared.transpose() / yaw) : place;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(held);
  if (place.trace() > 0.0) information.weakest_direction = solver.eigenvectors().col(0);
  information.least = solver.eigenvalues()[0] > kRounding * place.trace() ? solver.eigenvalues()[0] : 0.0;
  // Directions that nothing holds share nothing with yaw.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(place);
  information.yaw = yaw;
  for (int i = 0; i < 2; ++i) {
    const double along = axes.eigenvalues()[i];
    const double common = axes.eigenvectors().col(i).dot(shared);
    if (along > kRounding * place.trace()) information.yaw -= common * common / along;
  }
  if (!(information.yaw > kRounding * yaw)) information.yaw = 0.0;
  return information;
}

}  // namespace alignability::detail
