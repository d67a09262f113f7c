// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/log_map.hpp"

#include <tbb/enumerable_thread_specific.h>

#include <cmath>
#include <limits>
#include <map>
#include <mutex>
#include <stdexcept>

#include "alignability/cell_summary.hpp"
#include "core/range.hpp"
#include "lidar/in_parallel.hpp"
#include "lidar/simulate_scan.hpp"

namespace alignability {
namespace {

ScoredPlace score_of(const Scan& scan, const PosedScan& posed, const LogMapOptions& options, Scorer& scorer) {
  const Eigen::Isometry3d& T_base_scan = options.alignability.T_base_scan;
  const Eigen::Isometry3d T_map_base = posed.T_map_lidar * T_base_scan.inverse();
  return {T_map_base, detail::in_map(scorer.alignability(scan), T_map_base.linear(), T_base_scan.linear())};
}

std::string to_yaml(const LogMapOptions& options) {
  const std::string range = options.range_max ? "range_max: " + to_text(*options.range_max) + '\n' : "";
  return range + to_yaml(options.alignability);
}

// Scores what `seen_at(i)` gives for each place in the log.
template <typename SeenAt>
std::vector<ScoredPlace> scored(std::span<const PosedScan> scans, const LogMapOptions& options, SeenAt seen_at) {
  Scorer{options.alignability};  // throws for options that no scan could be scored with
  if (options.range_max && !kPositive.contains(*options.range_max)) throw std::invalid_argument("range_max must be greater than 0");
  std::vector<ScoredPlace> places(scans.size());
  std::mutex mutex;
  Progress progress{0, scans.size()};
  const auto tell_of_one_more = [&] {
    const std::scoped_lock lock(mutex);
    ++progress.done;
    if (options.progress) options.progress(progress);
  };
  tbb::enumerable_thread_specific<Scorer> scorers([&] { return Scorer(options.alignability); });
  in_parallel(scans.size(), options.threads, [&](std::size_t i) {
    if (options.stop.stop_requested()) throw Interrupted();
    places[i] = score_of(seen_at(i), scans[i], options, scorers.local());
    tell_of_one_more();
  });
  return places;
}

}  // namespace

std::vector<ScoredPlace> score_log(std::span<const PosedScan> scans, const LogMapOptions& options) {
  return scored(scans, options, [&](std::size_t i) {
    Scan scan = scan_of(scans[i]);
    return options.range_max ? cropped(std::move(scan), *options.range_max) : scan;
  });
}

std::vector<ScoredPlace> score_simulated_log(std::span<const PosedScan> scans, const Scene& scene, const LidarModel& lidar,
                                             std::uint64_t seed, const LogMapOptions& options) {
  return scored(scans, options, [&](std::size_t i) {
    return simulate_scan(scene, lidar, scans[i].T_map_lidar, {.range_max = options.range_max},
                         NoiseKey{.seed = seed, .cell = 0, .sample = i});
  });
}

GridGeometry geometry_around(std::span<const ScoredPlace> places, double resolution) {
  constexpr double kMostCells = 1 << 26;
  constexpr double kRim = 1.0;
  if (!kPositive.contains(resolution)) throw std::invalid_argument("the resolution must be greater than 0");
  if (places.empty()) throw std::invalid_argument("without places there is no map");
  Eigen::Array2d low = Eigen::Array2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Array2d high = -low;
  for (const ScoredPlace& place : places) {
    const Eigen::Array2d cell = (place.T_map_base.translation().head<2>().array() / resolution).floor();
    low = low.min(cell);
    high = high.max(cell);
  }
  const Eigen::Array2d size = high - low + 1.0 + 2.0 * kRim;
  if (size.prod() > kMostCells) {
    throw std::invalid_argument("the places spread over " + fixed_text(size.x() * resolution, 0) + " x " +
                                fixed_text(size.y() * resolution, 0) + " m, too many cells of " + to_text(resolution) +
                                " m; take larger ones, or those of an occupancy map");
  }
  return {.resolution = resolution,
          .origin = resolution * (low - kRim).matrix(),
          .width = static_cast<int>(size.x()),
          .height = static_cast<int>(size.y())};
}

AlignabilityMap map_of(std::span<const ScoredPlace> places, const GridGeometry& geometry, const LogMapOptions& options) {
  std::map<std::size_t, std::vector<Alignability>> by_cell;
  for (const ScoredPlace& place : places) {
    const auto cell = geometry.cell_near(place.T_map_base.translation().head<2>());
    if (cell) by_cell[geometry.index(*cell)].push_back(place.score);
  }
  AlignabilityMap map;
  map.geometry = geometry;
  map.options = to_yaml(options);
  for (const std::string& name : detail::layer_names(options.alignability)) {
    map.layers.push_back({name, Grid<float>(geometry, std::numeric_limits<float>::quiet_NaN())});
  }
  for (const auto& [cell, scores] : by_cell) {
    const CellValue value = detail::summary(scores, options.alignability);
    for (std::size_t layer = 0; layer < value.size(); ++layer) map.layers[layer].values[cell] = value[layer];
  }
  return map;
}

}  // namespace alignability
