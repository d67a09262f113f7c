// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <string>
#include <vector>

namespace alignability {

/// Evenly spaced azimuths, both ends among them but for a full circle, whose last column stands one step before `max`, which would repeat
/// the first. Counter-clockwise from the lidar's +x [rad].
struct AzimuthSector {
  double min = 0.0;
  double max = 0.0;
  int columns = 0;

  bool full_circle() const;
};

/// A spinning, solid-state or planar lidar: where its beams go, how far they see, how noisy they are and where it sits on the robot.
struct LidarModel {
  std::string name;
  /// Angle above the lidar's xy plane [rad], one a ring, in the order of the rings.
  std::vector<double> elevations;
  /// What each ring adds to the azimuths of its columns [rad]; empty where none adds any.
  std::vector<double> azimuth_offsets;
  /// What it looks into, counter-clockwise; between them it is blind. The columns of a ring are theirs one after the other.
  std::vector<AzimuthSector> sectors;
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
  int columns() const;  ///< beams a ring
  /// Whether it looks into one sector of 360 degrees.
  bool full_circle() const;
  /// Whether it is a 2D lidar that sees the world in plan: one ring, its beams level in `base_link` to within a degree, either side up.
  bool is_planar() const;
};

/// Unit vectors in the `lidar` frame, ring-major as the points of a Scan.
std::vector<Eigen::Vector3f> beam_directions(const LidarModel& model);

/// Reads a sensor file of one lidar. Every key but `mount` is required; at most 1024 rings and 2^22 beams. The rings are `elevation_deg`, a
/// list or {min, max, count}, or `rings_deg`, a list of [elevation, azimuth offset]; `azimuth_deg` is one sector {min, max, count} or a
/// list of them. `mount.rpy_deg` is roll, pitch, yaw about the fixed axes x, y, z, in this order. Throws InputError at the key that is
/// wrong, and for a file of several lidars, which `read_sensor_rig` reads.
LidarModel read_lidar_model(const std::filesystem::path& file);

/// The same for the text of a sensor file, as maps keep it; `file` is the name that errors show.
LidarModel parse_lidar_model(const std::string& yaml, const std::filesystem::path& file);

}  // namespace alignability
