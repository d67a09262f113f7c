// SPDX-License-Identifier: BSD-3-Clause
#include "cli/drive_paths.hpp"

#include <iostream>

#include "cli/progress_bar.hpp"
#include "core/input_error.hpp"
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

void drive_all(std::vector<DrivenPath>& paths, const DriveSite& site, TrialOptions trials) {
  std::vector<std::vector<Pose2>> ways;
  for (const DrivenPath& path : paths) ways.push_back(path.path);
  ProgressBar bar("drives");
  trials.progress = bar.callback();
  std::vector<std::vector<Drive>> drives = drive_trials(site.scene, site.lidar, site.map, ways, trials);
  for (std::size_t i = 0; i < paths.size(); ++i) paths[i].runs = std::move(drives[i]);
}

}  // namespace alignability::cli
