// SPDX-License-Identifier: BSD-3-Clause
// Plays a recorded log to a monitor, as a robot would its scans: monitor_log MAP.yaml SCANS TRAJECTORY SENSOR.yaml [RANGE_MAX]
// The trajectory holds poses of base_link.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "alignability/monitor.hpp"
#include "lidar/scan_file.hpp"
#include "lidar/scan_log.hpp"
#include "lidar/trajectory.hpp"

using namespace alignability;

namespace {

int monitor(int count, char** words) {
  const LidarModel lidar = read_lidar_model(words[4]);
  MonitorOptions options;
  options.alignability = for_lidar(options.alignability, lidar);
  if (count > 5) options.range_max = std::strtod(words[5], nullptr);
  Monitor monitor(read_alignability_map(words[1]), options);
  const ScanLogOptions log{.frame = TrajectoryFrame::base_link, .T_base_lidar = lidar.T_base_lidar};
  for (const PosedScan& scan : read_scan_log(words[2], read_trajectory(words[3]), log).scans) {
    const Eigen::Isometry3d T_map_base = scan.T_map_lidar * lidar.T_base_lidar.inverse();
    const Eigen::Vector3d at = T_map_base.translation();
    const Eigen::Vector3d ahead = T_map_base.linear().col(0);
    const MonitorReading reading =
        monitor.update(read_scan_file(scan.file), {at.x(), at.y(), std::atan2(ahead.y(), ahead.x())}, scan.stamp);
    std::printf("%s: expected %.3f, seen %.3f", scan.file.filename().c_str(), reading.expected, reading.seen);
    if (reading.low_since) std::printf(", low since %.3f, by %.3f in the mean", *reading.low_since, reading.lower_in_mean);
    std::printf("\n");
  }
  return 0;
}

}  // namespace

int main(int count, char** words) {
  if (count < 5) {
    std::fprintf(stderr, "usage: monitor_log MAP.yaml SCANS TRAJECTORY SENSOR.yaml [RANGE_MAX]\n");
    return 2;
  }
  try {
    return monitor(count, words);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
