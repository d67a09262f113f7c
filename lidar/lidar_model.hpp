// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <string>
#include <vector>

namespace alignability {

/// A spinning or planar lidar: where its beams go, how far they see, how noisy they are and where it sits on the robot.
struct LidarModel {
  std::string name;
  /// Angle above the lidar's xy plane [rad], one a ring, in the order of the rings.
  std::vector<double> elevations;
  /// Counter-clockwise from the lidar's +x [rad]; `columns` beams a ring from the one to the other. Where they are a full circle apart
  /// the last column stands one step before `azimuth_max`, which would repeat the first.
  double azimuth_min = 0.0;
  double azimuth_max = 0.0;
  int columns = 0;
  /// Returns outside [range_min, range_max] are none [m].
  double range_min = 0.0;
  double range_max = 0.0;
  /// Standard deviation of a measured range [m].
  double range_stddev = 0.0;
  /// Turns a second [Hz].
  double rate = 0.0;
  /// The mount: the lidar in `base_link`.
  Eigen::Isometry3d T_base_lidar = Eigen::Isometry3d::Identity();
  /// The text of the file it was read from, verbatim; empty when it was not read from one.
  std::string yaml;

  int rings() const { return static_cast<int>(elevations.size()); }
  bool full_circle() const;
};

/// Unit vectors in the `lidar` frame, ring-major as the points of a Scan.
std::vector<Eigen::Vector3f> beam_directions(const LidarModel& model);

/// Reads a sensor file. Every key but `mount` is required; at most 1024 rings and 2^22 beams. `mount.rpy_deg` is roll, pitch, yaw about the
/// fixed axes x, y, z, in this order. Throws InputError at the key that is wrong.
LidarModel read_lidar_model(const std::filesystem::path& file);

/// The same for the text of a sensor file, as maps keep it; `file` is the name that errors show.
LidarModel parse_lidar_model(const std::string& yaml, const std::filesystem::path& file);

}  // namespace alignability
