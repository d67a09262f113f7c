// SPDX-License-Identifier: BSD-3-Clause
#include "localization/trials.hpp"

#include <mutex>
#include <stdexcept>

#include "lidar/in_parallel.hpp"

namespace alignability {

std::vector<std::vector<Drive>> drive_trials(const Scene& scene, const SensorRig& sensor, const LocalizationMap& map,
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
  in_parallel(paths.size() * runs, options.threads, [&](std::size_t number) {
    const std::size_t path = number / runs;
    const std::size_t run = number % runs;
    drives[path][run] = drive(scene, sensor, map, paths[path], options.drive, options.seed + run, options.stop);
    const std::scoped_lock lock(mutex);
    ++progress.done;
    report();
  });
  return drives;
}

}  // namespace alignability
