// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>

#include "costmap/error_model.hpp"
#include "costmap/risk_field.hpp"
#include "localization/drive.hpp"
#include "localization/validation.hpp"

namespace alignability {

/// For what a model is fitted: one localizer of a drive, given by number.
Calibration calibration_of(const DriveOptions& drive, std::size_t localizer, const LidarModel& lidar, std::optional<double> range_max);

/// The model, but for its calibration, that is nearest by least squares to the 95th percentiles of the error over the runs of some paths,
/// every half metre after the first two. α is that of `risk`. Of alpha_poor and alpha_rich it takes the best of a few, the rest is fitted
/// by Levenberg's and Marquardt's method. Throws std::invalid_argument where no path is longer than two metres.
ErrorModel fit_error_model(std::span<const DrivenPath> paths, std::size_t localizer, const RiskField& risk);

/// How a model fares on paths.
struct ErrorModelCheck {
  double rms = 0.0;      ///< between the 95th percentiles of errors and what is predicted of them, root mean square [m]
  double covered = 0.0;  ///< share of the scans with an error of at most the prediction; 0.95 is meant
};

ErrorModelCheck check_error_model(const ErrorModel& model, std::span<const DrivenPath> paths, std::size_t localizer, const RiskField& risk);

}  // namespace alignability
