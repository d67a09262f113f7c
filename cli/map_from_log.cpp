// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <chrono>
#include <iostream>
#include <sstream>

#include "alignability/log_map.hpp"
#include "cli/exit_code.hpp"
#include "cli/interrupt.hpp"
#include "cli/map_builds.hpp"
#include "cli/map_output.hpp"
#include "cli/output_name.hpp"
#include "cli/progress_bar.hpp"
#include "core/file.hpp"
#include "core/range.hpp"
#include "costmap/map_server.hpp"

namespace alignability::cli {
namespace {

// The last part of a folder's name, whether or not a slash follows it.
std::string folder_name(const std::filesystem::path& folder) {
  const std::filesystem::path plain = (folder / "").parent_path();
  return plain.filename().string();
}

// A log's name comes first: `is_logged` looks for it there.
std::string provenance(const MapCommandOptions& options, const ScanLog& log) {
  std::string text = "log: " + folder_name(options.log.folder);
  if (!options.log.trajectory.empty()) text += "\ntrajectory: " + options.log.trajectory.filename().string();
  text += "\nposes_of: ";
  text += options.log.reading.frame == TrajectoryFrame::lidar ? "lidar" : "base_link";
  text += "\npaired_by: ";
  text += to_string(log.pairing);
  text += "\nscans: " + std::to_string(log.scans.size());
  if (options.occupancy) text += "\noccupancy: " + options.occupancy->filename().string();
  if (options.sensor) text += "\nsensor: " + options.sensor->filename().string();
  return text += "\nmade_by: alignability " ALIGNABILITY_VERSION "\n";
}

std::size_t off_the_map(const std::vector<ScoredPlace>& places, const GridGeometry& cells) {
  return static_cast<std::size_t>(
      std::ranges::count_if(places, [&](const ScoredPlace& place) { return !cells.cell_near(place.T_map_base.translation().head<2>()); }));
}

void warn(const ScanLog& log, const std::vector<ScoredPlace>& places, std::size_t off) {
  const auto empty = std::ranges::find(places, std::size_t{0}, [](const ScoredPlace& place) { return place.score.points; });
  if (empty != places.end()) {
    const PosedScan& scan = log.scans[static_cast<std::size_t>(empty - places.begin())];
    std::cerr << "warning: " << scan.file.string() << ": no point counts; a scan that sees nothing reads 0\n";
  }
  if (off > 0) std::cerr << "warning: " << off << " of " << places.size() << " scans were taken off the map and are left out\n";
}

std::string csv(const ScanLog& log, const std::vector<ScoredPlace>& places) {
  std::ostringstream out;
  out << "scan,stamp,x,y,z,alpha,points,planes\n";
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Eigen::Vector3d at = places[i].T_map_base.translation();
    const Alignability& score = places[i].score;
    out << log.scans[i].file.filename().string() << ',' << fixed_text(log.scans[i].stamp, 6) << ',' << fixed_text(at.x(), 4) << ','
        << fixed_text(at.y(), 4) << ',' << fixed_text(at.z(), 4) << ',' << fixed_text(score.alpha, 6) << ',' << score.points << ','
        << score.planes_kept << '\n';
  }
  return out.str();
}

std::vector<ScoredPlace> scored(const ScanLog& log, LogMapOptions options) {
  ProgressBar bar("scans");
  options.progress = bar.callback();
  return score_log(log.scans, options);
}

}  // namespace

int map_from_log(const MapCommandOptions& options) {
  const Interrupt interrupt;
  const auto begin = std::chrono::steady_clock::now();
  const auto lidar = options.sensor ? std::optional(read_lidar_model(*options.sensor)) : std::nullopt;
  const auto occupancy = options.occupancy ? std::optional(read_occupancy_map(*options.occupancy)) : std::nullopt;
  const ScanLog log = read_log(options.log, lidar);
  LogMapOptions scoring{.range_max = options.map.range_max,
                        .alignability = options.map.alignability,
                        .threads = options.map.threads,
                        .progress = {},
                        .stop = interrupt.token()};
  if (lidar) scoring.alignability = for_lidar(scoring.alignability, *lidar);
  const std::vector<ScoredPlace> places = scored(log, scoring);
  const GridGeometry cells =
      occupancy ? alignability_geometry(occupancy->geometry(), options.map.resolution) : geometry_around(places, options.map.resolution);
  const std::size_t off = off_the_map(places, cells);
  warn(log, places, off);
  AlignabilityMap map = map_of(places, cells, scoring);
  map.provenance = provenance(options, log);
  if (lidar) map.sensor = lidar->yaml;

  const std::filesystem::path name = output_name(options.output);
  write_file(with_ending(name, ".csv"), csv(log, places));
  store_map(map, occupancy.value_or(open_ground(cells)), name, options.pictures);
  std::vector<std::filesystem::path> files = map_files(name, options.pictures);
  files.push_back(with_ending(name, ".csv"));
  Json summary = map_json(map, seconds_since(begin), files);
  summary["scans_without_a_pose"] = log.without_a_pose.size();
  summary["scans_off_the_map"] = off;
  tell(summary, options.json);
  return kYes;
}

}  // namespace alignability::cli
