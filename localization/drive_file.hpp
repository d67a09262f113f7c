// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "localization/drive.hpp"

namespace alignability {

/// Reads what drives and how it is localized, every key optional:
///
///     speed: 1.0                      # [m/s]
///     turn_rate_deg: 45               # [deg/s]
///     odometry: {scale_bias: 0.02, heading_bias_deg: 0.1, position_noise: 0.01, heading_noise_deg: 0.2, turning_noise_deg: 1}
///     localizers: [ndt_mcl_sum]       # names of kLocalizers
///     particles: 100
///     regularization: {least_effective: 0.3, bandwidths: 1}    # of NDT-MCL; without the key it is as published
///     cell: 0.4                       # of the NDT [m]
///     motion_noise: {per_metre: [0.05, 0.05, 0.01], per_radian: [0.1, 0.01, 0.1]}    # what localizers assume
///     start_deviations: {position: 0.1, heading_deg: 1}
///
/// Biases and noise of odometry are by metre, √m and √rad as OdometryError has them, angles in degrees. Without `odometry` it is perfect.
/// Throws InputError at the key that is wrong.
DriveOptions read_drive_file(const std::filesystem::path& yaml_file);

}  // namespace alignability
