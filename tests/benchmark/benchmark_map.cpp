// SPDX-License-Identifier: BSD-3-Clause
// benchmark_map: where the time of a map's scans goes, what a second thread gains, and what memory ten times the scans take. Run it where
// maps/ is.
#include <sys/resource.h>

#include <chrono>
#include <cstdio>
#include <random>

#include "alignability/build_map.hpp"
#include "costmap/map_server.hpp"
#include "lidar/sdf_world.hpp"
#include "lidar/simulate_scan.hpp"

namespace alignability {
namespace {

constexpr double kRangeMax = 6.5;
constexpr int kScans = 200;

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

// [ms] a call, over all scans.
template <typename Work>
double milliseconds(Work work) {
  const double begin = now();
  for (int scan = 0; scan < kScans; ++scan) work(scan);
  return 1e3 * (now() - begin) / kScans;
}

double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

std::vector<Eigen::Isometry3d> random_poses(const Scene& scene, const LidarModel& lidar) {
  std::mt19937_64 engine(1);
  std::vector<Eigen::Isometry3d> poses;
  while (static_cast<int>(poses.size()) < kScans) {
    Eigen::Isometry3d pose = lidar.T_base_lidar;
    for (int axis = 0; axis < 2; ++axis) {
      pose.translation()[axis] += std::uniform_real_distribution<double>(scene.bounds().min()[axis], scene.bounds().max()[axis])(engine);
    }
    if (scene.is_free(pose.translation().cast<float>(), kSensorClearance)) poses.push_back(pose);
  }
  return poses;
}

void print_split(const Scene& scene, const LidarModel& lidar) {
  const std::vector<Eigen::Isometry3d> poses = random_poses(scene, lidar);
  const auto pose = [&](int scan) -> const Eigen::Isometry3d& { return poses[static_cast<std::size_t>(scan)]; };
  const std::vector<Eigen::Vector3f> beams = beam_directions(lidar);
  const double tracing =
      milliseconds([&](int scan) { scene.cast(pose(scan).translation().cast<float>(), beams, static_cast<float>(kRangeMax)); });
  std::vector<Scan> scans;
  const double simulating = milliseconds([&](int scan) {
    const NoiseKey noise{.seed = 1, .cell = static_cast<std::uint64_t>(scan), .sample = 0};
    scans.push_back(simulate_scan(scene, lidar, pose(scan), {.range_max = kRangeMax}, noise));
  });
  AlignabilityOptions options = for_lidar({}, lidar);
  const auto scoring = [&] {
    Scorer scorer(options);
    return milliseconds([&](int scan) { scorer.alignability(scans[static_cast<std::size_t>(scan)]); });
  };
  const double exact = scoring();
  options.segmentation.stride = kMostStride;
  const double strided = scoring();
  std::printf(
      "ms a scan: tracing %.2f, noise and the rest of the simulation %.2f, scoring %.2f, with stride %d %.2f (%.1f times the tracing)\n",
      tracing, simulating - tracing, exact, kMostStride, strided, strided / tracing);
}

// Seconds for the same part of the map.
double build_seconds(const Scene& scene, const OccupancyMap& occupancy, const LidarModel& lidar, int threads) {
  MapOptions options;
  options.range_max = kRangeMax;
  options.samples = 2;
  options.threads = threads;
  options.alignability = for_lidar({}, lidar);
  options.cells.emplace();
  for (int y = 5; y < 15; ++y) {
    for (int x = 20; x < 30; ++x) options.cells->push_back({x, y});
  }
  const double begin = now();
  build_alignability_map(scene, occupancy, lidar, options);
  return now() - begin;
}

void print_memory(const Scene& scene, const OccupancyMap& occupancy, const LidarModel& lidar) {
  for (const int samples : {1, 10}) {
    MapOptions options;
    options.range_max = kRangeMax;
    options.samples = samples;
    options.alignability = for_lidar({}, lidar);
    const double begin = now();
    build_alignability_map(scene, occupancy, lidar, options);
    std::printf("%d scan(s) a cell: %.0f s on all processors, peak memory so far %.1f MB\n", samples, now() - begin, peak_megabytes());
    std::fflush(stdout);
  }
}

int run() {
  const Scene scene(read_world("maps/warehouse/warehouse.sdf").meshes);
  const OccupancyMap occupancy = read_occupancy_map("maps/warehouse/occupancy.yaml");
  const LidarModel lidar = read_lidar_model("maps/sensors/hdl32e.yaml");
  print_split(scene, lidar);
  const double one = build_seconds(scene, occupancy, lidar, 1);
  const double two = build_seconds(scene, occupancy, lidar, 2);
  std::printf("a part of the map: one thread %.2f s, two %.2f s, %.2f times as fast\n", one, two, one / two);
  std::fflush(stdout);
  print_memory(scene, occupancy, lidar);
  return 0;
}

}  // namespace
}  // namespace alignability

int main() { return alignability::run(); }
