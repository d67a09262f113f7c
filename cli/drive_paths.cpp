// SPDX-License-Identifier: BSD-3-Clause
#include "cli/drive_paths.hpp"

#include <iostream>

#include "cli/progress_bar.hpp"
#include "core/input_error.hpp"
#include "core/range.hpp"
#include "planner/route_file.hpp"

namespace alignability::cli {

std::vector<DrivenPath> read_paths(std::span<const std::filesystem::path> files) {
  std::vector<DrivenPath> paths;
  for (const std::filesystem::path& file : files) {
    Route route = read_route(file, {});
    for (const std::string& remark : route.remarks) std::cerr << file.string() << ": " << remark << '\n';
    if (route.path.empty()) throw InputError(file, "this is a graph: drive a path (CSV)");
    paths.push_back({file.stem().string(), std::move(route.path), {}});
  }
  return paths;
}

std::vector<DrivenPath> driven(std::vector<DrivenPath> paths, const DriveSite& site, TrialOptions trials) {
  std::vector<std::vector<Pose2>> ways;
  for (const DrivenPath& path : paths) ways.push_back(path.path);
  ProgressBar bar("drives");
  trials.progress = bar.callback();
  std::vector<std::vector<Drive>> drives = drive_trials(site.scene, site.sensor, site.map, ways, trials);
  for (std::size_t i = 0; i < paths.size(); ++i) paths[i].runs = std::move(drives[i]);
  return paths;
}

LocalizerErrors errors_of(const DrivenPath& path, std::size_t localizer, const ClearanceMap& clearance, double radius) {
  return {path_errors({&path.runs, 1}, localizer, clearance, radius, {}), errors_along(path.runs, localizer, kErrorStep)};
}

void warn_of_collisions(std::span<const DrivenPath> paths, const ClearanceMap& clearance, double radius) {
  for (const DrivenPath& path : paths) {
    for (std::size_t i = 1; i < path.path.size(); ++i) {
      // A path may keep to its distance to within rounding.
      if (clearance.is_clear(path.path[i - 1].position(), path.path[i].position(), radius - 1e-6)) continue;
      std::cerr << "warning: " << path.name << " leads the robot into an obstacle or off the map near x " << to_text(path.path[i].x)
                << ", y " << to_text(path.path[i].y) << '\n';
      break;
    }
  }
}

}  // namespace alignability::cli
