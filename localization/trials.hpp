// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "core/progress.hpp"
#include "localization/drive.hpp"

namespace alignability {

struct TrialOptions {
  DriveOptions drive;
  int runs = 20;           ///< of each path, >= 1
  std::uint64_t seed = 1;  ///< of the first run; each further one has the next
  int threads = 0;         ///< 0: one a processor
  ProgressCallback progress = {};
  std::stop_token stop = {};
};

/// Drives each path several times, with the same errors on every path (paired). By path, then by run; the same whatever the number of
/// threads. Throws Interrupted, and std::invalid_argument for options out of range.
std::vector<std::vector<Drive>> drive_trials(const Scene& scene, const SensorRig& sensor, const LocalizationMap& map,
                                             std::span<const std::vector<Pose2>> paths, const TrialOptions& options);

}  // namespace alignability
