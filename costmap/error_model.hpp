// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace alignability {

/// For what an error model was fitted; it tells nothing of anything else.
struct Calibration {
  std::string localizer;
  std::string sensor;               ///< its name
  double noise = 0.0;               ///< of ranges, standard deviation [m]
  std::optional<double> range_max;  ///< [m] where the sensor's range was cropped
  double scale_bias = 0.0;          ///< of odometry
  bool operator==(const Calibration&) const = default;
};

/// What the 95th percentile E of a localizer's error [m] is expected to be along a path: over each metre
///
///     dE/ds = growth·ρ − (E − least)·(1 − ρ)/recovery,
///
/// ρ = 1 where α is at most `alpha_poor`, 0 where it is at least `alpha_rich`, linear between. It grows evenly where the robot is blind,
/// and where α is rich returns to the least. The greater α, at every place, the smaller E.
struct ErrorModel {
  double growth = 0.0;      ///< [m/m], >= 0
  double recovery = 1.0;    ///< metres on which what an error exceeds the least by shrinks to 1/e, > 0
  double least = 0.0;       ///< [m], >= 0
  double alpha_poor = 0.1;  ///< in [0, alpha_rich)
  double alpha_rich = 0.4;  ///< in (alpha_poor, 1]
  Calibration calibration;

  /// What a way makes of the error with which it begins.
  struct Change {
    double offset = 0.0;  ///< [m]
    double factor = 1.0;

    double of(double error) const { return offset + factor * error; }
    Change then(const Change& next) const { return {next.offset + next.factor * offset, next.factor * factor}; }
  };

  /// 1 where α is NaN.
  double poverty(double alpha) const;
  /// That of so many metres at one α, exactly.
  Change change(double alpha, double metres) const;
  /// E after so many metres at one α; never below the least.
  double advanced(double error, double alpha, double metres) const;

  bool operator==(const ErrorModel&) const = default;
};

/// In what a model was fitted for something else than it is used for, a sentence each.
std::vector<std::string> mismatches(const Calibration& fitted, const Calibration& used);

}  // namespace alignability
