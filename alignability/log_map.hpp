// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "alignability/alignability.hpp"
#include "core/progress.hpp"
#include "costmap/alignability_map.hpp"
#include "lidar/lidar_model.hpp"
#include "lidar/scan_log.hpp"
#include "lidar/scene.hpp"

namespace alignability {

struct LogMapOptions {
  std::optional<double> range_max = {};  ///< [m] leaves out what is farther, as if the sensor had not seen it
  AlignabilityOptions alignability = {};
  int threads = 0;  ///< 0: one a processor
  ProgressCallback progress = {};
  std::stop_token stop = {};
};

/// A scan of a log, where `base_link` was and how well the scan constrains alignment; directions in `map`.
struct ScoredPlace {
  Eigen::Isometry3d T_map_base = Eigen::Isometry3d::Identity();
  Alignability score;
};

/// Reads and scores each scan, in their order; the mount is that of `options.alignability`. The same for any number of threads. Throws
/// InputError for a scan that cannot be read, Interrupted, std::invalid_argument for options out of range.
std::vector<ScoredPlace> score_log(std::span<const PosedScan> scans, const LogMapOptions& options);

/// The same of what the lidar sees of the scene from the poses of the scans, whose files are not read, with its noise: the draws of a scan
/// are keyed by the seed and its place in the log. Holds a log against a site.
std::vector<ScoredPlace> score_simulated_log(std::span<const PosedScan> scans, const Scene& scene, const LidarModel& lidar,
                                             std::uint64_t seed, const LogMapOptions& options);

/// The cells of that size, their corners on whole cells counted from the origin of `map`, that hold all places, and a rim of one cell
/// around. Throws std::invalid_argument for a resolution that is not greater than 0, no places, and where there would be more than 2^26
/// cells.
GridGeometry geometry_around(std::span<const ScoredPlace> places, double resolution);

/// The alignability map of places that were scanned: α of a cell is the median over the scans taken in it (Castellano-Quero et al., Eq. 2),
/// cells without scans NaN in every layer. Layers as of `build_alignability_map`. Places off the grid are passed over; `options` and
/// `seed` (0) say what there is to say, `sensor` and `provenance` are left to who knows them.
AlignabilityMap map_of(std::span<const ScoredPlace> places, const GridGeometry& geometry, const LogMapOptions& options);

}  // namespace alignability
