// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/build_map.hpp"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>
#include <mutex>
#include <random>
#include <sstream>

#include "core/range.hpp"
#include "lidar/simulate_scan.hpp"

namespace alignability {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr int kMostDraws = 20;

// The quantile of sorted values, linear between neighbours; q = 0.5 is the median.
double quantile(const std::vector<double>& sorted, double q) {
  const double at = q * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (at - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

struct CellValue {
  float alpha = kNan;
  float samples = kNan;
  float iqr = kNan;
  Eigen::Vector3f weakest = Eigen::Vector3f::Constant(kNan);
};

CellValue summary(std::vector<Alignability> scores, const Eigen::Matrix3d& R_map_lidar) {
  CellValue value;
  value.samples = static_cast<float>(scores.size());
  if (scores.empty()) return value;
  std::vector<double> alphas;
  Eigen::Matrix3d directions = Eigen::Matrix3d::Zero();
  for (const Alignability& score : scores) {
    alphas.push_back(score.alpha);
    const Eigen::Vector3d weakest = R_map_lidar * score.weakest_direction;
    directions += weakest * weakest.transpose();
  }
  std::ranges::sort(alphas);
  value.alpha = static_cast<float>(quantile(alphas, 0.5));
  value.iqr = static_cast<float>(quantile(alphas, 0.75) - quantile(alphas, 0.25));
  if (directions.trace() > 0.0) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(directions);
    value.weakest = solver.eigenvectors().col(2).cast<float>();
    Eigen::Index largest = 0;
    value.weakest.cwiseAbs().maxCoeff(&largest);
    if (value.weakest[largest] < 0.0f) value.weakest = -value.weakest;
  }
  return value;
}

// Evaluates one cell after the other; each is independent of the rest.
class CellEvaluator {
 public:
  CellEvaluator(const Scene& scene, const LidarModel& lidar, const MapOptions& options) : scene_(scene), lidar_(lidar), options_(options) {}

  CellValue operator()(const FreePart& free, std::size_t cell, Scorer& scorer) const {
    std::vector<Alignability> scores;
    for (int sample = 0; sample < options_.samples; ++sample) {
      if (options_.stop.stop_requested()) throw Interrupted();
      if (const auto pose = sensor_pose(free, cell, sample)) {
        const NoiseKey noise{options_.seed, cell, static_cast<std::uint64_t>(sample)};
        const Scan scan = simulate_scan(scene_, lidar_, *pose, {.range_max = options_.range_max}, noise);
        scores.push_back(scorer.alignability(scan));
      }
    }
    return summary(std::move(scores), lidar_.T_base_lidar.linear());
  }

 private:
  std::optional<Eigen::Isometry3d> sensor_pose(const FreePart& free, std::size_t cell, int sample) const {
    const auto word = [](std::uint64_t value, int half) { return static_cast<std::uint32_t>(value >> (32 * half)); };
    constexpr std::uint32_t kPlaces = 0x706c6163;  // apart from the noise, which is keyed by the same numbers
    std::seed_seq key{
        word(options_.seed, 0), word(options_.seed, 1), word(cell, 0), word(cell, 1), static_cast<std::uint32_t>(sample), kPlaces};
    std::mt19937_64 engine(key);
    const auto uniform = [&engine] { return static_cast<double>(engine() >> 11) * 0x1p-53; };
    for (int draw = 0; draw < kMostDraws; ++draw) {
      const double share = (sample + uniform()) / options_.samples;
      const double u = uniform();
      const double v = uniform();
      Eigen::Isometry3d T_map_base = Eigen::Isometry3d::Identity();
      T_map_base.translation() << free.at(share, u, v), options_.floor;
      const Eigen::Isometry3d T_map_lidar = T_map_base * lidar_.T_base_lidar;
      if (scene_.is_free(T_map_lidar.translation().cast<float>(), kSensorClearance)) return T_map_lidar;
    }
    return std::nullopt;
  }

  const Scene& scene_;
  const LidarModel& lidar_;
  const MapOptions& options_;
};

// Tells of progress, one call at a time.
class Reporter {
 public:
  Reporter(const ProgressCallback& callback, std::size_t total) : callback_(callback), progress_{0, total} { report(); }

  void advance() {
    const std::scoped_lock lock(mutex_);
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
    for (const Cell cell : *options.cells) {
      if (!geometry.contains(cell)) throw std::invalid_argument("a cell to evaluate lies off the map");
      add(cell);
    }
  } else {
    for (std::size_t i = 0; i < geometry.size(); ++i) add(geometry.cell_of(i));
  }
  return jobs;
}

std::vector<CellValue> evaluate(const std::vector<Job>& jobs, const CellEvaluator& evaluator, const MapOptions& options) {
  std::vector<CellValue> values(jobs.size());
  Reporter reporter(options.progress, jobs.size());
  tbb::task_arena arena(options.threads > 0 ? options.threads : tbb::task_arena::automatic);
  arena.execute([&] {
    // Workers compute in this thread's floating-point mode, whoever woke them first.
    tbb::task_group_context context(tbb::task_group_context::isolated,
                                    tbb::task_group_context::default_traits | tbb::task_group_context::fp_settings);
    context.capture_fp_settings();
    tbb::enumerable_thread_specific<Scorer> scorers([&] { return Scorer(options.alignability); });
    const auto evaluate_range = [&](const tbb::blocked_range<std::size_t>& range) {
      Scorer& scorer = scorers.local();
      for (std::size_t i = range.begin(); i != range.end(); ++i) {
        values[i] = evaluator(jobs[i].free, jobs[i].cell, scorer);
        reporter.advance();
      }
    };
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, jobs.size(), 1), evaluate_range, tbb::simple_partitioner(), context);
  });
  return values;
}

std::vector<AlignabilityMap::Layer> layers_of(const GridGeometry& geometry, const std::vector<Job>& jobs,
                                              const std::vector<CellValue>& values) {
  std::vector<AlignabilityMap::Layer> layers;
  const auto add = [&](const char* name, auto value_of) {
    Grid<float> grid(geometry, kNan);
    for (std::size_t i = 0; i < jobs.size(); ++i) grid[jobs[i].cell] = value_of(values[i]);
    layers.push_back({name, std::move(grid)});
  };
  add("alpha", [](const CellValue& value) { return value.alpha; });
  add("samples", [](const CellValue& value) { return value.samples; });
  add("iqr", [](const CellValue& value) { return value.iqr; });
  add("weak_x", [](const CellValue& value) { return value.weakest.x(); });
  add("weak_y", [](const CellValue& value) { return value.weakest.y(); });
  add("weak_z", [](const CellValue& value) { return value.weakest.z(); });
  return layers;
}

std::string to_yaml(const MapOptions& options) {
  std::ostringstream out;
  out << "samples: " << options.samples << '\n';
  if (options.range_max) out << "range_max: " << to_text(*options.range_max) << '\n';
  out << "floor: " << to_text(options.floor) << '\n'
      << "occupied_above: " << to_text(options.rule.occupied_above) << '\n'
      << "max_occupied_share: " << to_text(options.rule.max_occupied_share) << '\n'
      << to_yaml(options.alignability);
  return out.str();
}

void check(const OccupancyMap& occupancy, const MapOptions& options) {
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

AlignabilityMap build_alignability_map(const Scene& scene, const OccupancyMap& occupancy, const LidarModel& lidar,
                                       const MapOptions& options) {
  check(occupancy, options);
  AlignabilityMap map;
  map.geometry = alignability_geometry(occupancy.geometry(), options.resolution);
  map.seed = options.seed;
  map.options = to_yaml(options);
  map.sensor = lidar.yaml;
  const std::vector<Job> jobs = jobs_for(occupancy, map.geometry, options);
  map.layers = layers_of(map.geometry, jobs, evaluate(jobs, CellEvaluator(scene, lidar, options), options));
  return map;
}

}  // namespace alignability
