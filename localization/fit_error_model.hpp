// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "costmap/error_model.hpp"
#include "costmap/risk_field.hpp"
#include "localization/drive.hpp"
#include "localization/validation.hpp"

namespace alignability {

/// For what a model is fitted: one localizer of a drive, given by number.
Calibration calibration_of(const DriveOptions& drive, std::size_t localizer, const SensorRig& sensor, std::optional<double> range_max);

/// Paths that are driven on one site, and its α.
struct SitePaths {
  std::span<const DrivenPath> paths;
  const RiskField& risk;
};

/// Why no model can be fitted to paths: they must lead over at least four metres with α of at most 0.2 and four of at least 0.3, beyond the
/// first two of each path, or nothing is known of growth or of recovery. nullopt where it can.
std::optional<std::string> refusal_of_fit(std::span<const SitePaths> sites);

/// The model, but for its calibration, that is nearest by least squares to the 95th percentiles of the error over the runs of some paths,
/// every half metre after the first two. Of alpha_poor and alpha_rich it takes the best of a few of which the paths
/// have four metres on either side; the rest is fitted by Levenberg's and Marquardt's method. Throws std::invalid_argument for paths that
/// are refused.
ErrorModel fit_error_model(std::span<const SitePaths> sites, std::size_t localizer);

/// How a model fares along a path, from what the error is after the first two metres on.
struct ErrorModelCheck {
  double rms = 0.0;      ///< between the 95th percentiles of errors and what is predicted of them, root mean square [m]
  double covered = 0.0;  ///< share of the scans with an error of at most the prediction; 0.95 is meant
};

/// nullopt for a path that is not longer than two metres.
std::optional<ErrorModelCheck> check_error_model(const ErrorModel& model, const DrivenPath& path, std::size_t localizer,
                                                 const RiskField& risk);

}  // namespace alignability
