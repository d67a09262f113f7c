// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/pose.hpp"

namespace alignability {

struct Particle {
  Pose2 pose;
  double weight;
};

/// What keeps a particle filter from gathering where no particle is near the truth. Two surfaces match within centimetres only, so that of
/// 100 particles scattered over half a metre often none is close, and yet one scan, of hundreds of matches taken for independent, leaves a
/// single one; and what is drawn from a few comes back to a few. Costs no further evaluation of the likelihood.
struct Regularization {
  /// Greater than 0 and less than resample_below: a scan that would leave fewer effective particles than this share of them is taken to the
  /// power less than 1 that leaves so many. As in adaptive tempering (Jasra et al. 2011), but the rest of the scan is dropped: filters that
  /// take each reading for independent are overconfident (Thrun, Burgard and Fox 2005, 6.3).
  double least_effective = 0.3;
  /// Drawn particles are scattered by a Gaussian kernel: the covariance of all, times the square of so many optimal bandwidths, in [0, 1]
  /// (Musso, Oudjane and Le Gland 2001); and drawn together by as much, so that their covariance stays (Liu and West 2001). Else it would
  /// grow without end along a plain corridor.
  double bandwidths = 1.0;
};

/// Weights that add up to 1, of their logarithms up to a constant.
std::vector<double> normalized_weights(std::span<const double> logs);

/// Of normalized weights: one over the sum of their squares, between 1 and their number.
double effective_number(std::span<const double> weights);

/// The power, at most 1, to which the likelihoods are taken lest the effective number fall below one that the weights as they are exceed.
double power_that_keeps(double effective, std::span<const double> log_weights, std::span<const double> log_likelihoods);

/// Of a Gaussian kernel for so many samples of a Gaussian in three dimensions, in its deviations: (4 / 5n)^(1/7).
double optimal_bandwidth(int particles);

/// The weighted mean; that of yaw is of directions.
Pose2 mean_of(std::span<const Particle> particles);

/// A matrix A such that A·Aᵀ is the weighted covariance of x, y and yaw.
Eigen::Matrix3d covariance_root(std::span<const Particle> particles);

}  // namespace alignability
