// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/progress.hpp"
#include "costmap/occupancy_map.hpp"
#include "lidar/scene.hpp"
#include "lidar/sensor_rig.hpp"

namespace alignability {

struct SurveyOptions {
  double spacing = 2.0;                  ///< between the places surveyed from [m]
  double thinning = 0.05;                ///< side of the cubes of which each gives one point [m]
  std::optional<double> range_max = {};  ///< [m] crops the sensor's own range
  double floor = 0.0;                    ///< z of `base_link` in `map` [m]
  int threads = 0;                       ///< 0: one a processor
  ProgressCallback progress = {};
  std::stop_token stop = {};
};

/// The cloud that scans without noise make of a site, taken at the free places of a lattice: its surfaces as a robot sees them, in `map`
/// but for z, which counts from the floor,
/// and not the far sides of walls, which would blur the cells that they share with the near ones. The same cloud for any number of threads.
/// Throws std::invalid_argument for options out of range, and Interrupted.
std::vector<Eigen::Vector3f> survey(const Scene& scene, const OccupancyMap& occupancy, const SensorRig& sensor,
                                    const SurveyOptions& options);

}  // namespace alignability
