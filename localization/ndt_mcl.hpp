// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <random>
#include <span>
#include <vector>

#include "core/pose.hpp"
#include "localization/motion_noise.hpp"
#include "localization/ndt.hpp"
#include "localization/regularization.hpp"

namespace alignability {

/// How the matches of a scan's cells make a weight.
enum class CellCombination {
  sum,      ///< 1 + Σ: as published and implemented; flat
  product,  ///< Π: of independent cells, each with an outlier floor
};

struct NdtMclOptions {
  int particles = 100;
  CellCombination combination = CellCombination::sum;
  MotionNoise noise = {};
  double least_height = 0.2;    ///< scan cells lower than this above `base_link` [m] are skipped: the floor tells x, y and yaw nothing
  double resample_below = 0.5;  ///< particles are drawn anew when their effective number falls below this share,
  int resample_after = 25;      ///< or after so many scans
  /// None: as published, which of starts 0.5 m and 2° off in a rich room converges from about half. With it from all that were tried, and
  /// with the product errors are larger by half afterwards.
  std::optional<Regularization> regularization = {};
};

/// What a match is worth: 0.1 + 0.9·exp(−0.05·d²/2), d the Mahalanobis distance of the two means under both covariances. Where the map has
/// no cell d is infinite for the product; the sum counts matches alone.
double match_score(double distance2);

/// Monte Carlo localization on a normal distributions transform (Saarinen et al. 2013): particles of (x, y, yaw), weighted by how well the
/// NDT of a scan lies on that of the map. The same seed gives the same particles. Not for several threads.
class NdtMcl {
 public:
  /// Particles around a start, normally distributed by the deviations. Throws std::invalid_argument for options out of range.
  NdtMcl(std::shared_ptr<const Ndt> map, const Pose2& start, const Pose2& deviations, const NdtMclOptions& options, std::uint64_t seed);

  /// Takes the motion that odometry reports, from the last pose's frame.
  void move(const Pose2& motion);
  /// Takes what the lidar sees, its points in the frame of `base_link`. O(particles · cells of the scan).
  void see(const Ndt& scan);

  /// The particles' mean.
  Pose2 estimate() const;
  /// Their weights add up to 1.
  std::span<const Particle> particles() const { return particles_; }

 private:
  double normal();
  void resample();
  void scatter(std::span<Particle> drawn);

  std::shared_ptr<const Ndt> map_;
  NdtMclOptions options_;
  std::mt19937_64 engine_;
  std::vector<Particle> particles_;
  int seen_ = 0;  // since particles were drawn
};

}  // namespace alignability
