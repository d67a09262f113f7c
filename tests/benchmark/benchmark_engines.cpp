// SPDX-License-Identifier: BSD-3-Clause
// The native engine beside PCL, one thread each: how far α differs, beside how far PCL's own α moves when the points are permuted or
// jittered by a micrometre, and how long each takes.
//
//   benchmark_engines PLACES SCENE SENSOR [RANGE_MAX]     scans simulated at that many free places, with 0, 0.8 and 2 cm noise
//   benchmark_engines SCAN…                               recorded scans
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "alignability/alignability.hpp"
#include "core/distribution.hpp"
#include "core/range.hpp"
#include "core/rank_correlation.hpp"
#include "lidar/lidar_model.hpp"
#include "lidar/scan_file.hpp"
#include "lidar/scene.hpp"
#include "lidar/sdf_world.hpp"
#include "lidar/simulate_scan.hpp"

namespace alignability {
namespace {

constexpr int kStride = 4;

struct Engines {
  explicit Engines(double range_min) {
    AlignabilityOptions options;
    options.segmentation.range_min = range_min;
    native.emplace(options);
    options.segmentation.stride = kStride;
    strided.emplace(options);
    options.segmentation.stride = 1;
    options.segmentation.engine = Engine::pcl;
    pcl.emplace(options);
  }

  std::optional<Scorer> pcl;
  std::optional<Scorer> native;
  std::optional<Scorer> strided;
};

struct Timed {
  double alpha = 0.0;
  double seconds = 0.0;
};

struct Row {
  std::string scan;
  Timed pcl;
  Timed native;
  Timed strided;
  Timed pcl_unorganized;
  Timed native_unorganized;
  double own_spread = 0.0;  ///< of PCL's α, permuted or jittered
};

Timed timed(Scorer& scorer, const Scan& scan) {
  const auto begin = std::chrono::steady_clock::now();
  const double alpha = scorer.alignability(scan).alpha;
  return {alpha, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count()};
}

Scan permuted(Scan scan, std::mt19937_64& engine) {
  std::shuffle(scan.points.begin(), scan.points.end(), engine);
  scan.columns = static_cast<int>(scan.points.size());
  scan.rings = 1;
  return scan;
}

Scan jittered(Scan scan, std::mt19937_64& engine) {
  std::uniform_real_distribution<float> micrometre(-1e-6f, 1e-6f);
  for (Eigen::Vector3f& point : scan.points) point += Eigen::Vector3f(micrometre(engine), micrometre(engine), micrometre(engine));
  return scan;
}

Row measure(std::string name, Engines& engines, const Scan& scan, std::mt19937_64& engine) {
  Row row;
  row.scan = std::move(name);
  row.native = timed(*engines.native, scan);
  row.strided = timed(*engines.strided, scan);
  row.pcl = timed(*engines.pcl, scan);
  const Scan shuffled = permuted(scan, engine);
  row.native_unorganized = timed(*engines.native, shuffled);
  row.pcl_unorganized = timed(*engines.pcl, shuffled);
  const double by_jitter = std::abs(timed(*engines.pcl, jittered(scan, engine)).alpha - row.pcl.alpha);
  row.own_spread = std::max(by_jitter, std::abs(row.pcl_unorganized.alpha - row.pcl.alpha));
  return row;
}

double quantile_of(std::vector<double> values, double share) {
  std::ranges::sort(values);
  return quantile(values, share);
}

template <typename Value>
std::vector<double> each(const std::vector<Row>& rows, Value value) {
  std::vector<double> values;
  for (const Row& row : rows) values.push_back(value(row));
  return values;
}

void print(const std::string& what, const std::vector<Row>& rows) {
  const auto alpha = [&](auto member) { return each(rows, [&](const Row& row) { return (row.*member).alpha; }); };
  const auto median_ms = [&](auto member) {
    return 1e3 * quantile_of(each(rows, [&](const Row& row) { return (row.*member).seconds; }), 0.5);
  };
  const auto off = [&](auto member, double share) {
    return quantile_of(each(rows, [&](const Row& row) { return std::abs((row.*member).alpha - row.pcl.alpha); }), share);
  };
  const std::vector<double> own = each(rows, [](const Row& row) { return row.own_spread; });
  const auto within = std::ranges::count_if(
      rows, [](const Row& row) { return std::abs(row.native.alpha - row.pcl.alpha) <= std::max(0.005, row.own_spread); });
  std::printf("%s: %zu scans\n", what.c_str(), rows.size());
  std::printf("  PCL's own spread   median %.5f, 99 %% %.5f, max %.5f\n", quantile_of(own, 0.5), quantile_of(own, 0.99),
              quantile_of(own, 1.0));
  std::printf("  native off PCL     median %.5f, 99 %% %.5f, max %.5f; within max(0.005, own) %.1f %%; Spearman %.5f\n",
              off(&Row::native, 0.5), off(&Row::native, 0.99), off(&Row::native, 1.0),
              100.0 * static_cast<double>(within) / static_cast<double>(rows.size()),
              rank_correlation(alpha(&Row::native), alpha(&Row::pcl)));
  const Row& worst = std::ranges::max(rows, {}, [](const Row& row) { return std::abs(row.native.alpha - row.pcl.alpha); });
  std::printf("  most off           %s: PCL %.5f, native %.5f, PCL's own spread %.5f\n", worst.scan.c_str(), worst.pcl.alpha,
              worst.native.alpha, worst.own_spread);
  std::printf("  stride %d off PCL   median %.5f, 99 %% %.5f, max %.5f; Spearman %.5f\n", kStride, off(&Row::strided, 0.5),
              off(&Row::strided, 0.99), off(&Row::strided, 1.0), rank_correlation(alpha(&Row::strided), alpha(&Row::pcl)));
  const double pcl = median_ms(&Row::pcl);
  std::printf("  ms a scan          PCL %.1f, native %.1f (%.1f x), stride %d %.1f (%.1f x)\n", pcl, median_ms(&Row::native),
              pcl / median_ms(&Row::native), kStride, median_ms(&Row::strided), pcl / median_ms(&Row::strided));
  std::printf("  permuted           PCL %.1f, native %.1f (%.1f x)\n", median_ms(&Row::pcl_unorganized),
              median_ms(&Row::native_unorganized), median_ms(&Row::pcl_unorganized) / median_ms(&Row::native_unorganized));
}

std::string place_text(const Eigen::Isometry3d& T_map_lidar) {
  return fixed_text(T_map_lidar.translation().x(), 2) + ", " + fixed_text(T_map_lidar.translation().y(), 2);
}

void simulate(int places, const std::string& world, const std::string& sensor, std::optional<double> range_max) {
  const Scene scene(read_world(world).meshes);
  LidarModel lidar = read_lidar_model(sensor);
  Engines engines(lidar.range_min);
  std::vector<Row> all;
  for (const double stddev : {0.0, 0.008, 0.02}) {
    lidar.range_stddev = stddev;
    std::mt19937_64 engine(1);
    std::vector<Row> rows;
    while (static_cast<int>(rows.size()) < places) {
      Eigen::Isometry3d pose = lidar.T_base_lidar;
      for (int axis = 0; axis < 2; ++axis) {
        pose.translation()[axis] += std::uniform_real_distribution<double>(scene.bounds().min()[axis], scene.bounds().max()[axis])(engine);
      }
      if (!scene.is_free(pose.translation().cast<float>(), 0.1f)) continue;
      const Scan scan = simulate_scan(scene, lidar, pose, {.range_max = range_max}, NoiseKey{.seed = 1, .cell = rows.size(), .sample = 0});
      rows.push_back(measure(place_text(pose), engines, scan, engine));
    }
    print(world + ", noise " + fixed_text(100.0 * stddev, 1) + " cm", rows);
    std::ranges::move(rows, std::back_inserter(all));
  }
  print(world + ", all", all);
}

int run(const std::vector<std::string>& words) {
  if (words.empty()) {
    std::fputs("usage: benchmark_engines PLACES SCENE SENSOR [RANGE_MAX] | benchmark_engines SCAN…\n", stderr);
    return 2;
  }
  if (std::ranges::all_of(words.front(), [](char c) { return c >= '0' && c <= '9'; }) && words.size() >= 3) {
    simulate(std::stoi(words[0]), words[1], words[2], words.size() > 3 ? std::optional(std::stod(words[3])) : std::nullopt);
    return 0;
  }
  Engines engines(0.5);
  std::mt19937_64 engine(1);
  std::vector<Row> rows;
  for (const std::string& file : words) rows.push_back(measure(file, engines, read_scan_file(file), engine));
  print("recorded", rows);
  return 0;
}

}  // namespace
}  // namespace alignability

int main(int argc, char** argv) { return alignability::run({argv + 1, argv + argc}); }
