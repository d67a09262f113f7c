// SPDX-License-Identifier: BSD-3-Clause
#include "localization/regularization.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstddef>

namespace alignability {
namespace {

constexpr int kHalvings = 40;

}  // namespace

std::vector<double> normalized_weights(std::span<const double> logs) {
  const double most = std::ranges::max(logs);
  std::vector<double> weights;
  double sum = 0.0;
  for (const double log : logs) sum += weights.emplace_back(std::exp(log - most));
  for (double& weight : weights) weight /= sum;
  return weights;
}

double effective_number(std::span<const double> weights) {
  double squares = 0.0;
  for (const double weight : weights) squares += weight * weight;
  return 1.0 / squares;
}

double power_that_keeps(double effective, std::span<const double> log_weights, std::span<const double> log_likelihoods) {
  const auto keeps = [&](double power) {
    std::vector<double> logs(log_weights.begin(), log_weights.end());
    for (std::size_t i = 0; i < logs.size(); ++i) logs[i] += power * log_likelihoods[i];
    return effective_number(normalized_weights(logs)) >= effective;
  };
  if (keeps(1.0)) return 1.0;
  double low = 0.0, high = 1.0;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (keeps(middle) ? low : high) = middle;
  }
  return low;
}

double optimal_bandwidth(int particles) { return std::pow(4.0 / (5.0 * particles), 1.0 / 7.0); }

Pose2 mean_of(std::span<const Particle> particles) {
  Pose2 mean;
  double c = 0.0, s = 0.0;
  for (const auto& [pose, weight] : particles) {
    mean.x += weight * pose.x;
    mean.y += weight * pose.y;
    c += weight * std::cos(pose.yaw);
    s += weight * std::sin(pose.yaw);
  }
  mean.yaw = std::atan2(s, c);
  return mean;
}

Eigen::Matrix3d covariance_root(std::span<const Particle> particles) {
  const Pose2 mean = mean_of(particles);
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const auto& [pose, weight] : particles) {
    const Eigen::Vector3d apart(pose.x - mean.x, pose.y - mean.y, normalized_angle(pose.yaw - mean.yaw));
    covariance += weight * apart * apart.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  const Eigen::Vector3d deviations = solver.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  return solver.eigenvectors() * deviations.asDiagonal();
}

}  // namespace alignability
