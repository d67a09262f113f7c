// SPDX-License-Identifier: BSD-3-Clause
#include "localization/ndt_mcl.hpp"

#include <algorithm>
#include <boost/random/normal_distribution.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/range.hpp"

namespace alignability {
namespace {

// The cosine and sine of a yaw, and where it turns to.
struct Turn {
  explicit Turn(double yaw) : c(std::cos(yaw)), s(std::sin(yaw)) {}

  Eigen::Vector3d operator()(const Eigen::Vector3d& v) const { return {c * v.x() - s * v.y(), s * v.x() + c * v.y(), v.z()}; }

  double c;
  double s;
};

// vᵀ·(A + R·B·Rᵀ)⁻¹·v, A and B symmetric, R the turn; element by element, for here a scan spends its time.
double mahalanobis2(const Eigen::Vector3d& v, const Eigen::Matrix3d& A, const Turn& turn, const Eigen::Matrix3d& B) {
  const double cc = turn.c * turn.c, ss = turn.s * turn.s, cs = turn.c * turn.s;
  const double xx = A(0, 0) + cc * B(0, 0) - 2.0 * cs * B(0, 1) + ss * B(1, 1);
  const double yy = A(1, 1) + ss * B(0, 0) + 2.0 * cs * B(0, 1) + cc * B(1, 1);
  const double zz = A(2, 2) + B(2, 2);
  const double xy = A(0, 1) + cs * (B(0, 0) - B(1, 1)) + (cc - ss) * B(0, 1);
  const double xz = A(0, 2) + turn.c * B(0, 2) - turn.s * B(1, 2);
  const double yz = A(1, 2) + turn.s * B(0, 2) + turn.c * B(1, 2);
  const double to_xx = yy * zz - yz * yz, to_xy = xz * yz - xy * zz, to_xz = xy * yz - xz * yy;
  const double to_yy = xx * zz - xz * xz, to_yz = xy * xz - xx * yz, to_zz = xx * yy - xy * xy;
  const double determinant = xx * to_xx + xy * to_xy + xz * to_xz;
  const double twice = v.x() * (to_xy * v.y() + to_xz * v.z()) + to_yz * v.y() * v.z();
  return (to_xx * v.x() * v.x() + to_yy * v.y() * v.y() + to_zz * v.z() * v.z() + 2.0 * twice) / determinant;
}

// Infinite where the map has no cell.
double distance2(const Ndt& map, const NdtCell& seen, const Turn& turn, const Eigen::Vector3d& place) {
  const Eigen::Vector3d mean = turn(seen.mean) + place;
  const NdtCell* const there = map.find(mean);
  if (there == nullptr) return std::numeric_limits<double>::infinity();
  return mahalanobis2(mean - there->mean, there->covariance, turn, seen.covariance);
}

// The logarithm of a weight.
double log_weight(const Ndt& map, std::span<const NdtCell> scan, const Pose2& pose, CellCombination combination) {
  const Turn turn(pose.yaw);
  const Eigen::Vector3d place(pose.x, pose.y, 0.0);
  const double log_of_none = std::log(match_score(std::numeric_limits<double>::infinity()));
  double sum = 0.0;
  for (const NdtCell& seen : scan) {
    const double d2 = distance2(map, seen, turn, place);
    if (combination == CellCombination::product) {
      sum += std::isfinite(d2) ? std::log(match_score(d2)) : log_of_none;
    } else if (std::isfinite(d2)) {
      sum += match_score(d2);
    }
  }
  return combination == CellCombination::product ? sum : std::log1p(sum);
}

void require(const Regularization& regularization, double resample_below) {
  const auto& [least_effective, bandwidths] = regularization;
  if (!(least_effective > 0.0 && least_effective < resample_below)) {
    throw std::invalid_argument("least_effective must be greater than 0 and less than resample_below");
  }
  if (!kShare.contains(bandwidths)) throw std::invalid_argument("the bandwidths of a kernel must be from 0 to 1");
}

}  // namespace

double match_score(double distance2) { return 0.1 + 0.9 * std::exp(-0.05 * distance2 / 2.0); }

NdtMcl::NdtMcl(std::shared_ptr<const Ndt> map, const Pose2& start, const Pose2& deviations, const NdtMclOptions& options,
               std::uint64_t seed)
    : map_(std::move(map)), options_(options), engine_(seed) {
  if (options.particles < 1) throw std::invalid_argument("there must be at least one particle");
  if (options.resample_after < 1) throw std::invalid_argument("resample_after must be at least 1");
  if (options.regularization) require(*options.regularization, options.resample_below);
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
  std::vector<double> logs, likelihoods;
  for (const auto& [pose, weight] : particles_) {
    logs.push_back(std::log(weight));
    likelihoods.push_back(log_weight(*map_, cells, pose, options_.combination));
  }
  double power = 1.0;
  if (const auto& regularization = options_.regularization) {
    power = power_that_keeps(regularization->least_effective * options_.particles, logs, likelihoods);
  }
  for (std::size_t i = 0; i < logs.size(); ++i) logs[i] += power * likelihoods[i];
  const std::vector<double> weights = normalized_weights(logs);
  for (std::size_t i = 0; i < weights.size(); ++i) particles_[i].weight = weights[i];
  ++seen_;
  if (effective_number(weights) < options_.resample_below * options_.particles || seen_ >= options_.resample_after) resample();
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
  if (options_.regularization) scatter(drawn);
  particles_ = std::move(drawn);
  seen_ = 0;
}

// Draws them together by as much as it scatters them.
void NdtMcl::scatter(std::span<Particle> drawn) {
  const double bandwidth = options_.regularization->bandwidths * optimal_bandwidth(options_.particles);
  const double kept = std::sqrt(1.0 - bandwidth * bandwidth);
  const Pose2 mean = mean_of(particles_);
  const Eigen::Matrix3d root = covariance_root(particles_);
  for (Particle& particle : drawn) {
    const double first = normal(), second = normal(), third = normal();
    const Eigen::Vector3d by = bandwidth * root * Eigen::Vector3d(first, second, third);
    const Eigen::Vector2d at = mean.position() + kept * (particle.pose.position() - mean.position()) + by.head<2>();
    particle.pose = {at.x(), at.y(), normalized_angle(mean.yaw + kept * normalized_angle(particle.pose.yaw - mean.yaw) + by.z())};
  }
}

Pose2 NdtMcl::estimate() const { return mean_of(particles_); }

}  // namespace alignability
