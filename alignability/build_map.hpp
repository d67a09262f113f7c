// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <stop_token>
#include <vector>

#include "alignability/alignability.hpp"
#include "alignability/cell_samples.hpp"
#include "alignability/cell_work.hpp"
#include "core/progress.hpp"
#include "costmap/alignability_map.hpp"
#include "lidar/scene.hpp"
#include "lidar/sensor_rig.hpp"

namespace alignability {

struct MapOptions {
  double resolution = 1.0;          ///< side of an α-cell [m], at least that of the occupancy map
  int samples = 10;                 ///< scans a cell, >= 1
  std::optional<double> range_max;  ///< [m] crops the sensor's own range
  int headings = 1;                 ///< yaws 2πk/n of the robot, 1 to 360; of more than one each has a layer
  double floor = 0.0;               ///< z of `base_link` in `map` [m]
  std::uint64_t seed = 1;
  EvaluationRule rule;
  AlignabilityOptions alignability;
  /// Evaluates these alone where given; the others stay NaN.
  std::optional<std::vector<Cell>> cells;
  /// Keeps each cell in this file as soon as it is evaluated, and takes from it what an earlier build of the same site, sensor and options
  /// had done: a build killed at any moment goes on and ends in the same bytes. The file stays; who has stored the map removes it.
  std::optional<std::filesystem::path> checkpoint = {};
  int threads = 0;  ///< 0: one a processor
  /// Who evaluates the cells; the map is the same whoever does.
  CellSpread spread = spread_over_threads;
  ProgressCallback progress = {};
  std::stop_token stop = {};
};

/// The alignability map of a site (Castellano-Quero et al., Eq. 2): α of a cell is the median over scans simulated at places stratified
/// over its free part, `base_link` at yaw 0, range noise on. A place where a lidar would be in or within 10 cm of a surface is
/// drawn anew, and given up after 20 draws. Layers alpha, samples, iqr, weak_x, weak_y, weak_z (the axis nearest to the scans' weakest
/// directions, in `map`); then the medians of the readings asked for, of information `information` [1/m²], `information_yaw` [1/rad²] and
/// the weakest direction `information_x`, `information_y`. With `headings` n > 1 scans are taken at each of n yaws 2πk/n, at n times the
/// time; layers `alpha_heading_0` … tell α at each, NaN where a lidar would stand in a surface wherever it tried, and the others are those
/// of the heading at which α is lowest. The same bytes for any number of threads. Throws std::invalid_argument for
/// options out of range, Interrupted, and InputError for a checkpoint that cannot be written, is none, is another build's or that of one
/// under way.
AlignabilityMap build_alignability_map(const Scene& scene, const OccupancyMap& occupancy, const SensorRig& sensor,
                                       const MapOptions& options);

/// A digest of what the values of a map's cells depend on: surfaces, free space, sensor, options, seed and version; not the choice of
/// cells, nor who evaluates them. Maps of the same fingerprint have the same values wherever both have one.
std::uint64_t map_fingerprint(const Scene& scene, const OccupancyMap& occupancy, const SensorRig& sensor, const MapOptions& options);

/// The grid of α-cells over an occupancy map: the same lower left corner, and as many cells as hold it.
GridGeometry alignability_geometry(const GridGeometry& occupancy, double resolution);

}  // namespace alignability
