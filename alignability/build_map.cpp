// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/build_map.hpp"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <limits>
#include <mutex>
#include <sstream>

#include "alignability/cell_evaluator.hpp"
#include "alignability/checkpoint.hpp"
#include "core/range.hpp"
#include "lidar/in_parallel.hpp"

namespace alignability {
namespace {

using detail::CellEvaluator;
using detail::CellValue;

// Writes down what is done, and tells of it; one call at a time.
class Ledger {
 public:
  Ledger(const ProgressCallback& callback, Progress progress, detail::Checkpoint* checkpoint)
      : callback_(callback), progress_(progress), checkpoint_(checkpoint) {
    report();
  }

  void enter(std::size_t cell, const CellValue& value) {
    const std::scoped_lock lock(mutex_);
    if (checkpoint_ != nullptr) checkpoint_->append(cell, value);
    ++progress_.done;
    report();
  }

 private:
  void report() const {
    if (callback_) callback_(progress_);
  }

  const ProgressCallback& callback_;
  std::mutex mutex_;
  Progress progress_;
  detail::Checkpoint* checkpoint_;
};

struct Job {
  std::size_t cell;
  FreePart free;
};

std::vector<Job> jobs_for(const OccupancyMap& occupancy, const GridGeometry& geometry, const MapOptions& options) {
  std::vector<Job> jobs;
  const auto add = [&](Cell cell) {
    FreePart free(occupancy, geometry, cell, options.rule);
    if (free.is_evaluated()) jobs.push_back({geometry.index(cell), std::move(free)});
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
  return jobs;
}

std::vector<CellValue> evaluate(const std::vector<Job>& jobs, const CellEvaluator& evaluator, const MapOptions& options,
                                detail::Checkpoint* checkpoint) {
  std::vector<CellValue> values(jobs.size());
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    if (checkpoint != nullptr && checkpoint->found().contains(jobs[i].cell)) {
      values[i] = checkpoint->found().at(jobs[i].cell);
    } else {
      left.push_back(i);
    }
  }
  Ledger ledger(options.progress, {jobs.size() - left.size(), jobs.size()}, checkpoint);
  tbb::enumerable_thread_specific<Scorer> scorers([&] { return Scorer(options.alignability); });
  in_parallel(left.size(), options.threads, [&](std::size_t k) {
    const Job& job = jobs[left[k]];
    values[left[k]] = evaluator(job.free, job.cell, scorers.local());
    ledger.enter(job.cell, values[left[k]]);
  });
  return values;
}

std::vector<AlignabilityMap::Layer> layers_of(const GridGeometry& geometry, const std::vector<Job>& jobs,
                                              const std::vector<CellValue>& values, const std::vector<std::string>& names) {
  std::vector<AlignabilityMap::Layer> layers;
  for (std::size_t layer = 0; layer < names.size(); ++layer) {
    Grid<float> grid(geometry, std::numeric_limits<float>::quiet_NaN());
    for (std::size_t i = 0; i < jobs.size(); ++i) grid[jobs[i].cell] = values[i][layer];
    layers.push_back({names[layer], std::move(grid)});
  }
  return layers;
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

AlignabilityMap build_alignability_map(const Scene& scene, const OccupancyMap& occupancy, const SensorRig& sensor,
                                       const MapOptions& options) {
  check(occupancy, options);
  AlignabilityMap map;
  map.geometry = alignability_geometry(occupancy.geometry(), options.resolution);
  map.seed = options.seed;
  map.options = to_yaml(options);
  map.sensor = sensor.yaml;
  const std::vector<Job> jobs = jobs_for(occupancy, map.geometry, options);
  const std::vector<std::string> names = detail::layer_names(options.alignability, options.headings);
  std::optional<detail::Checkpoint> checkpoint;
  if (options.checkpoint) {
    const std::string all_options = map.options + "resolution: " + to_text(options.resolution) + '\n';
    checkpoint.emplace(*options.checkpoint, detail::fingerprint(scene, occupancy, sensor, all_options, options.seed), names.size());
  }
  const CellEvaluator evaluator(scene, sensor, options);
  map.layers = layers_of(map.geometry, jobs, evaluate(jobs, evaluator, options, checkpoint ? &*checkpoint : nullptr), names);
  return map;
}

}  // namespace alignability
