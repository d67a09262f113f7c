// SPDX-License-Identifier: BSD-3-Clause
#include "localization/trials.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <mutex>
#include <stdexcept>

namespace alignability {

std::vector<std::vector<Drive>> drive_trials(const Scene& scene, const LidarModel& lidar, const LocalizationMap& map,
                                             std::span<const std::vector<Pose2>> paths, const TrialOptions& options) {
  if (options.runs < 1) throw std::invalid_argument("a path must be driven at least once");
  const auto runs = static_cast<std::size_t>(options.runs);
  std::vector<std::vector<Drive>> drives(paths.size(), std::vector<Drive>(runs));
  std::mutex mutex;
  Progress progress{0, paths.size() * runs};
  const auto report = [&] {
    if (options.progress) options.progress(progress);
  };
  report();
  // Each thread drives with the processor's own floating-point settings, whatever the tracer's are.
  tbb::task_group_context context(tbb::task_group_context::isolated,
                                  tbb::task_group_context::default_traits | tbb::task_group_context::fp_settings);
  const auto drive_one = [&](std::size_t number) {
    const std::size_t path = number / runs;
    const std::size_t run = number % runs;
    drives[path][run] = drive(scene, lidar, map, paths[path], options.drive, options.seed + run, options.stop);
    const std::scoped_lock lock(mutex);
    ++progress.done;
    report();
  };
  tbb::task_arena arena(options.threads > 0 ? options.threads : tbb::task_arena::automatic);
  arena.execute([&] { tbb::parallel_for(std::size_t{0}, paths.size() * runs, drive_one, context); });
  return drives;
}

}  // namespace alignability
