// SPDX-License-Identifier: BSD-3-Clause
#include "localization/odometry.hpp"

#include <boost/random/normal_distribution.hpp>
#include <cmath>
#include <stdexcept>

#include "core/range.hpp"

namespace alignability {

Odometry::Odometry(const OdometryError& error, std::uint64_t seed) : error_(error), engine_(seed) {
  if (!kFinite.contains(error.scale_bias) || !kFinite.contains(error.heading_bias)) {
    throw std::invalid_argument("odometry biases must be finite");
  }
  for (const double noise : {error.position_noise, error.heading_noise, error.turning_noise}) {
    if (!kNotNegative.contains(noise)) throw std::invalid_argument("odometry noise must be at least 0");
  }
}

Pose2 Odometry::report(const Pose2& motion) {
  // Boost's, because the standard leaves open which numbers std::normal_distribution draws.
  boost::random::normal_distribution<double> normal;
  const double metres = motion.position().norm();
  const double root = std::sqrt(metres);
  const double scale = 1.0 + error_.scale_bias;
  const double x = scale * motion.x + error_.position_noise * root * normal(engine_);
  const double y = scale * motion.y + error_.position_noise * root * normal(engine_);
  const double yaw = motion.yaw + error_.heading_bias * metres + error_.heading_noise * root * normal(engine_) +
                     error_.turning_noise * std::sqrt(std::abs(motion.yaw)) * normal(engine_);
  return {x, y, yaw};
}

}  // namespace alignability
