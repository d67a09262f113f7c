// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "lidar/scan.hpp"
#include "lidar/trajectory.hpp"

namespace alignability {

/// What tells which pose belongs to which scan of a folder.
enum class Pairing {
  stamp,   ///< the number in the scan's name is a time: between the poses before and after it, turning and moving evenly
  number,  ///< the number in the scan's name is that of the pose
  order,   ///< the first scan by name belongs to the first pose, and so on
  none,    ///< the log itself has the poses of its scans
};

/// Whose poses a trajectory holds.
enum class TrajectoryFrame { lidar, base_link };

struct ScanLogOptions {
  /// Without it the trajectory's format tells: stamp for TUM, number where poses are numbered, order for KITTI.
  std::optional<Pairing> pairing = {};
  double max_gap = 0.1;  ///< by stamp: how far the nearest pose may be from a scan [s], >= 0
  TrajectoryFrame frame = TrajectoryFrame::lidar;
  Eigen::Isometry3d T_base_lidar = Eigen::Isometry3d::Identity();  ///< the mount, where poses are those of `base_link`
};

/// A scan and where the lidar was when it was taken.
struct PosedScan {
  std::filesystem::path file;
  double stamp = 0.0;  ///< [s]; 0 where the trajectory has none
  Eigen::Isometry3d T_map_lidar = Eigen::Isometry3d::Identity();
  std::optional<Scan> scan = {};  ///< of a log that holds its scans itself; without, `file` does
};

struct ScanLog {
  Pairing pairing = Pairing::order;
  std::vector<PosedScan> scans;                       ///< by name
  std::vector<std::filesystem::path> without_a_pose;  ///< by name
};

/// The scans of a folder, those of its files that end in .pcd, .ply or .bin, each with its pose; their content is not read. Names are
/// ordered as people count: 9.pcd before 10.pcd. The number in a name is its last, digits with or without a point; as a time, such as
/// 1630577758.569490, it is in seconds below 1e11, in milliseconds below 1e14, in microseconds below 1e17, else in nanoseconds.
/// Throws InputError where the folder cannot be read or has no scans, a name has no number or that of another, by order the folder does not
/// have as many scans as the trajectory poses, where the trajectory has nothing to pair by, and where no scan has a pose.
ScanLog read_scan_log(const std::filesystem::path& folder, const Trajectory& trajectory, const ScanLogOptions& options);

/// What the lidar saw, as the log has it. Throws InputError where the scan's file cannot be read.
Scan scan_of(const PosedScan& posed);

/// "stamp", "number", "order", "none".
std::string_view to_string(Pairing pairing);

/// The scan without its returns beyond a range [m]: those are NaN.
Scan cropped(Scan scan, double range_max);

}  // namespace alignability
