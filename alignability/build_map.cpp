// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/build_map.hpp"

#include <tbb/enumerable_thread_specific.h>

#include <limits>
#include <mutex>
#include <sstream>

#include "alignability/cell_evaluator.hpp"
#include "alignability/checkpoint.hpp"
#include "core/range.hpp"
#include "lidar/in_parallel.hpp"

namespace alignability {
namespace {

// Takes in what is evaluated: into the map, the checkpoint and the progress that is told; one call at a time.
class Ledger {
 public:
  Ledger(AlignabilityMap& map, detail::Checkpoint* checkpoint, const ProgressCallback& callback)
      : map_(map), checkpoint_(checkpoint), callback_(callback) {}

  /// Takes what the checkpoint has of these cells, and returns the others.
  std::vector<std::size_t> begin(const std::vector<std::size_t>& cells) {
    std::vector<std::size_t> left;
    for (const std::size_t cell : cells) {
      if (checkpoint_ != nullptr && checkpoint_->found().contains(cell)) {
        put(cell, checkpoint_->found().at(cell));
      } else {
        left.push_back(cell);
      }
    }
    progress_ = {cells.size() - left.size(), cells.size()};
    report();
    return left;
  }

  void enter(std::size_t cell, const CellValue& value) {
    const std::scoped_lock lock(mutex_);
    if (checkpoint_ != nullptr) checkpoint_->append(cell, value);
    put(cell, value);
    ++progress_.done;
    report();
  }

 private:
  void put(std::size_t cell, const CellValue& value) {
    for (std::size_t layer = 0; layer < map_.layers.size(); ++layer) map_.layers[layer].values[cell] = value[layer];
  }
  void report() const {
    if (callback_) callback_(progress_);
  }

  AlignabilityMap& map_;
  detail::Checkpoint* checkpoint_;
  const ProgressCallback& callback_;
  std::mutex mutex_;
  Progress progress_;
};

// Those that are to have a value.
std::vector<std::size_t> cells_to_evaluate(const OccupancyMap& occupancy, const GridGeometry& geometry, const MapOptions& options) {
  std::vector<std::size_t> cells;
  const auto add = [&](Cell cell) {
    if (FreePart(occupancy, geometry, cell, options.rule).is_evaluated()) cells.push_back(geometry.index(cell));
  };
  if (options.cells) {
    std::vector<bool> taken(geometry.size(), false);
    for (const Cell cell : *options.cells) {
      if (!geometry.contains(cell)) {
        throw std::invalid_argument("the cell " + std::to_string(cell.x) + "," + std::to_string(cell.y) + " lies off the map, which has " +
                                    std::to_string(geometry.width) + " x " + std::to_string(geometry.height));
      }
      if (!taken[geometry.index(cell)]) add(cell);
      taken[geometry.index(cell)] = true;
    }
  } else {
    for (std::size_t i = 0; i < geometry.size(); ++i) add(geometry.cell_of(i));
  }
  return cells;
}

std::string to_yaml(const MapOptions& options) {
  std::ostringstream out;
  out << "samples: " << options.samples << '\n';
  if (options.headings > 1) out << "headings: " << options.headings << '\n';
  if (options.range_max) out << "range_max: " << to_text(*options.range_max) << '\n';
  out << "floor: " << to_text(options.floor) << '\n'
      << "occupied_above: " << to_text(options.rule.occupied_above) << '\n'
      << "max_occupied_share: " << to_text(options.rule.max_occupied_share) << '\n'
      << to_yaml(options.alignability);
  return out.str();
}

void check(const OccupancyMap& occupancy, const MapOptions& options) {
  Scorer{options.alignability};  // throws for options that no scan could be scored with
  if (options.headings < 1 || options.headings > 360) throw std::invalid_argument("headings must be from 1 to 360");
  if (options.samples < 1) throw std::invalid_argument("samples must be at least 1");
  if (options.range_max && !kPositive.contains(*options.range_max)) throw std::invalid_argument("range_max must be greater than 0");
  if (!kPositive.contains(options.resolution) || options.resolution < occupancy.geometry().resolution) {
    throw std::invalid_argument("the resolution must be at least that of the occupancy map, " + to_text(occupancy.geometry().resolution) +
                                " m");
  }
}

}  // namespace

GridGeometry alignability_geometry(const GridGeometry& occupancy, double resolution) {
  constexpr double kRounding = 1e-9;
  const Eigen::Array2d cells = (occupancy.extent().array() / resolution - kRounding).ceil().max(1.0);
  return {
      .resolution = resolution, .origin = occupancy.origin, .width = static_cast<int>(cells.x()), .height = static_cast<int>(cells.y())};
}

std::uint64_t map_fingerprint(const Scene& scene, const OccupancyMap& occupancy, const SensorRig& sensor, const MapOptions& options) {
  const std::string all_options = to_yaml(options) + "resolution: " + to_text(options.resolution) + '\n';
  return detail::fingerprint(scene, occupancy, sensor, all_options, options.seed);
}

AlignabilityMap build_alignability_map(const Scene& scene, const OccupancyMap& occupancy, const SensorRig& sensor,
                                       const MapOptions& options) {
  check(occupancy, options);
  AlignabilityMap map;
  map.geometry = alignability_geometry(occupancy.geometry(), options.resolution);
  map.seed = options.seed;
  map.options = to_yaml(options);
  map.sensor = sensor.yaml;
  const Grid<float> nothing(map.geometry, std::numeric_limits<float>::quiet_NaN());
  for (const std::string& name : detail::layer_names(options.alignability, options.headings)) map.layers.push_back({name, nothing});
  const std::vector<std::size_t> cells = cells_to_evaluate(occupancy, map.geometry, options);

  std::optional<detail::Checkpoint> checkpoint;
  if (options.checkpoint) checkpoint.emplace(*options.checkpoint, map_fingerprint(scene, occupancy, sensor, options), map.layers.size());
  Ledger ledger(map, checkpoint ? &*checkpoint : nullptr, options.progress);
  const std::vector<std::size_t> left = ledger.begin(cells);
  const detail::CellEvaluator evaluator(scene, sensor, options);
  tbb::enumerable_thread_specific<Scorer> scorers([&] { return Scorer(options.alignability); });
  options.spread({.cells = left,
                  .evaluate =
                      [&](std::size_t cell) {
                        const FreePart free(occupancy, map.geometry, map.geometry.cell_of(cell), options.rule);
                        return evaluator(free, cell, scorers.local());
                      },
                  .enter = [&](std::size_t cell, const CellValue& value) { ledger.enter(cell, value); },
                  .threads = options.threads,
                  .stop = options.stop});
  return map;
}

void spread_over_threads(const CellWork& work) {
  in_parallel(work.cells.size(), work.threads, [&](std::size_t i) { work.enter(work.cells[i], work.evaluate(work.cells[i])); });
}

}  // namespace alignability
