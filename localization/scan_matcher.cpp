// SPDX-License-Identifier: BSD-3-Clause
#include "localization/scan_matcher.hpp"

#include <Eigen/LU>
#include <cmath>
#include <stdexcept>

#include "core/range.hpp"
#include "lidar/thinning.hpp"

namespace alignability {
namespace {

// A step that is shorter, in metres and radians, ends the iterations.
constexpr double kSettled = 1.0e-4;

// The sums of a Gauss-Newton step over all points.
struct Normals {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
};

Eigen::Vector3d vector_of(const Pose2& pose) { return {pose.x, pose.y, pose.yaw}; }

// What one pose lacks to the other.
Eigen::Vector3d difference(const Pose2& pose, const Pose2& other) {
  return {pose.x - other.x, pose.y - other.y, normalized_angle(pose.yaw - other.yaw)};
}

Normals normals_at(const PlaneMap& map, std::span<const Eigen::Vector3f> points, const Pose2& pose, const ScanMatcherOptions& options) {
  const double c = std::cos(pose.yaw), s = std::sin(pose.yaw);
  const double variance = options.deviation * options.deviation;
  const double outlier2 = options.outlier * options.outlier;
  Normals sums;
  for (const Eigen::Vector3f& point : points) {
    const Eigen::Vector3d p = point.cast<double>();
    const Eigen::Vector3d turned(c * p.x() - s * p.y(), s * p.x() + c * p.y(), p.z());
    const Eigen::Vector3d place = turned + Eigen::Vector3d(pose.x, pose.y, 0.0);
    const Surface* const surface = map.nearest(place);
    if (surface == nullptr) continue;
    const Eigen::Vector3d normal = surface->normal.cast<double>();
    const double residual = normal.dot(place - surface->point.cast<double>());
    const Eigen::Vector3d slope(normal.x(), normal.y(), normal.y() * turned.x() - normal.x() * turned.y());
    const double weight = options.independent_share / (variance + residual * residual / outlier2);
    sums.information += weight * slope * slope.transpose();
    sums.gradient -= weight * residual * slope;
  }
  return sums;
}

void check(const ScanMatcherOptions& options) {
  if (!kFinite.contains(options.least_height)) throw std::invalid_argument("least_height must be finite");
  for (const double value : {options.thinning, options.deviation, options.outlier}) {
    if (!kPositive.contains(value)) throw std::invalid_argument("thinning, deviation and outlier must be greater than 0");
  }
  if (!kPositive.contains(options.independent_share) || options.independent_share > 1.0) {
    throw std::invalid_argument("independent_share must be in (0, 1]");
  }
  if (options.iterations < 1) throw std::invalid_argument("there must be at least one iteration");
}

}  // namespace

ScanMatcher::ScanMatcher(std::shared_ptr<const PlaneMap> map, const Pose2& start, const Pose2& deviations,
                         const ScanMatcherOptions& options)
    : map_(std::move(map)), options_(options), pose_(start) {
  check(options);
  if (!vector_of(start).allFinite()) throw std::invalid_argument("a start must be finite");
  for (const double deviation : vector_of(deviations)) {
    if (!kNotNegative.contains(deviation)) throw std::invalid_argument("a start's deviations must be at least 0");
  }
  covariance_ = vector_of(deviations).array().square().matrix().asDiagonal();
}

void ScanMatcher::move(const Pose2& motion) {
  const double c = std::cos(pose_.yaw), s = std::sin(pose_.yaw);
  Eigen::Matrix3d by_pose = Eigen::Matrix3d::Identity();
  by_pose(0, 2) = -s * motion.x - c * motion.y;
  by_pose(1, 2) = c * motion.x - s * motion.y;
  Eigen::Matrix3d by_motion = Eigen::Matrix3d::Identity();
  by_motion.topLeftCorner<2, 2>() << c, -s, s, c;
  const Eigen::Vector3d variances = vector_of(deviations_of(motion, options_.noise)).array().square();
  covariance_ = by_pose * covariance_ * by_pose.transpose() + by_motion * variances.asDiagonal() * by_motion.transpose();
  pose_ = moved(pose_, motion);
}

// With P the predicted covariance, A and b the sums over points, x̄ the predicted pose: a step solves (P⁻¹ + A)·δ = b − P⁻¹·(x − x̄), here
// multiplied by P, which may be singular: what is known exactly stays so.
void ScanMatcher::see(std::span<const Eigen::Vector3f> points) {
  std::vector<Eigen::Vector3f> raised;
  for (const Eigen::Vector3f& point : points) {
    if (point.z() >= options_.least_height) raised.push_back(point);
  }
  const std::vector<Eigen::Vector3f> scan = thinned(raised, options_.thinning);
  const Pose2 predicted = pose_;
  Eigen::Matrix3d gain = Eigen::Matrix3d::Identity();  // (I + P·A)⁻¹
  for (int iteration = 0; iteration < options_.iterations; ++iteration) {
    const auto [information, gradient] = normals_at(*map_, scan, pose_, options_);
    gain = (Eigen::Matrix3d::Identity() + covariance_ * information).inverse();
    const Eigen::Vector3d step = gain * (covariance_ * gradient - difference(pose_, predicted));
    pose_ = {pose_.x + step.x(), pose_.y + step.y(), normalized_angle(pose_.yaw + step.z())};
    if (step.lpNorm<Eigen::Infinity>() < kSettled) break;
  }
  const Eigen::Matrix3d updated = gain * covariance_;
  covariance_ = 0.5 * (updated + updated.transpose());
}

}  // namespace alignability
