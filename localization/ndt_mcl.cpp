// SPDX-License-Identifier: BSD-3-Clause
#include "localization/ndt_mcl.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <boost/random/normal_distribution.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace alignability {
namespace {

// A yaw as the matrix that turns by it.
Eigen::Matrix3d turn(double yaw) {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
  matrix(0, 0) = matrix(1, 1) = std::cos(yaw);
  matrix(1, 0) = std::sin(yaw);
  matrix(0, 1) = -matrix(1, 0);
  return matrix;
}

// Infinite where the map has no cell.
double distance2(const Ndt& map, const NdtCell& seen, const Eigen::Matrix3d& R_map_base, const Eigen::Vector3d& place) {
  const Eigen::Vector3d mean = R_map_base * seen.mean + place;
  const NdtCell* const there = map.find(mean);
  if (there == nullptr) return std::numeric_limits<double>::infinity();
  const Eigen::Matrix3d both = there->covariance + R_map_base * seen.covariance * R_map_base.transpose();
  const Eigen::Vector3d apart = mean - there->mean;
  return apart.dot(both.inverse() * apart);
}

// The logarithm of a weight.
double log_weight(const Ndt& map, std::span<const NdtCell> scan, const Pose2& pose, CellCombination combination) {
  const Eigen::Matrix3d R_map_base = turn(pose.yaw);
  const Eigen::Vector3d place(pose.x, pose.y, 0.0);
  double sum = 0.0;
  for (const NdtCell& seen : scan) {
    const double d2 = distance2(map, seen, R_map_base, place);
    if (combination == CellCombination::product) {
      sum += std::log(match_score(d2));
    } else if (std::isfinite(d2)) {
      sum += match_score(d2);
    }
  }
  return combination == CellCombination::product ? sum : std::log1p(sum);
}

void normalize(std::vector<Particle>& particles) {
  double sum = 0.0;
  for (const Particle& particle : particles) sum += particle.weight;
  for (Particle& particle : particles) particle.weight /= sum;
}

}  // namespace

double match_score(double distance2) { return 0.1 + 0.9 * std::exp(-0.05 * distance2 / 2.0); }

NdtMcl::NdtMcl(std::shared_ptr<const Ndt> map, const Pose2& start, const Pose2& deviations, const NdtMclOptions& options,
               std::uint64_t seed)
    : map_(std::move(map)), options_(options), engine_(seed) {
  if (options.particles < 1) throw std::invalid_argument("there must be at least one particle");
  if (options.resample_after < 1) throw std::invalid_argument("resample_after must be at least 1");
  const double weight = 1.0 / options.particles;
  for (int i = 0; i < options.particles; ++i) {
    const double x = start.x + deviations.x * normal();
    const double y = start.y + deviations.y * normal();
    particles_.push_back({{x, y, normalized_angle(start.yaw + deviations.yaw * normal())}, weight});
  }
}

// Boost's, because the standard leaves open which numbers std::normal_distribution draws.
double NdtMcl::normal() { return boost::random::normal_distribution<double>()(engine_); }

void NdtMcl::move(const Pose2& motion) {
  const Pose2 deviations = deviations_of(motion, options_.noise);
  for (Particle& particle : particles_) {
    const double x = motion.x + deviations.x * normal();
    const double y = motion.y + deviations.y * normal();
    const double yaw = motion.yaw + deviations.yaw * normal();
    particle.pose = moved(particle.pose, {x, y, yaw});
  }
}

void NdtMcl::see(const Ndt& scan) {
  std::vector<NdtCell> cells;
  for (const NdtCell& cell : scan.cells()) {
    if (cell.mean.z() >= options_.least_height) cells.push_back(cell);
  }
  std::vector<double> logs;
  for (const auto& [pose, weight] : particles_) {
    logs.push_back(std::log(weight) + log_weight(*map_, cells, pose, options_.combination));
  }
  const double most = std::ranges::max(logs);  // of a particle that has a weight: finite
  for (std::size_t i = 0; i < particles_.size(); ++i) particles_[i].weight = std::exp(logs[i] - most);
  normalize(particles_);
  ++seen_;
  double squares = 0.0;
  for (const Particle& particle : particles_) squares += particle.weight * particle.weight;
  if (1.0 / squares < options_.resample_below * options_.particles || seen_ >= options_.resample_after) resample();
}

// Systematically: one draw for all.
void NdtMcl::resample() {
  const double share = 1.0 / options_.particles;
  double at = share * static_cast<double>(engine_() >> 11) * 0x1p-53;
  double below = 0.0;
  std::vector<Particle> drawn;
  for (const Particle& particle : particles_) {
    below += particle.weight;
    for (; at < below && drawn.size() < particles_.size(); at += share) drawn.push_back({particle.pose, share});
  }
  while (drawn.size() < particles_.size()) drawn.push_back({particles_.back().pose, share});  // rounding
  particles_ = std::move(drawn);
  seen_ = 0;
}

Pose2 NdtMcl::estimate() const {
  Pose2 mean;
  double c = 0.0, s = 0.0;
  for (const auto& [pose, weight] : particles_) {
    mean.x += weight * pose.x;
    mean.y += weight * pose.y;
    c += weight * std::cos(pose.yaw);
    s += weight * std::sin(pose.yaw);
  }
  mean.yaw = std::atan2(s, c);
  return mean;
}

}  // namespace alignability
