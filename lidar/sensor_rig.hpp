// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "lidar/lidar_model.hpp"

namespace alignability {

/// The lidars of a robot, scored together. One lidar is a rig too; its scans stay in the `lidar` frame, those of several are joined in
/// `base_link`, one lidar after the other, each ring-major.
struct SensorRig {
  std::string name;
  /// At least one; all planar or none, and of one rate, for their scans count as taken in the same instant.
  std::vector<LidarModel> lidars;
  /// The text of the file it was read from, verbatim; empty when it was not read from one.
  std::string yaml;

  SensorRig() = default;
  SensorRig(LidarModel lidar);  // NOLINT(google-explicit-constructor): whatever takes a rig takes a lidar

  bool is_planar() const { return lidars.front().is_planar(); }
  /// Whether some beam of it goes to every side of the robot: in `base_link` the azimuths of its beams lie no further apart than twice the
  /// widest step between columns, or a degree. A lidar that leans may do so and still see another thing at every heading. O(beams log
  /// beams).
  bool sees_all_around() const;
  /// Turns a second [Hz].
  double rate() const { return lidars.front().rate; }
  /// The least of its lidars' [m].
  double range_min() const;
  /// The largest of its lidars' [m]: what is said of points without saying whose they are.
  double range_stddev() const;
  std::size_t beams() const;
  /// The frame of its scans in `base_link`: the mount of the one lidar, or none.
  Eigen::Isometry3d T_base_scan() const;
};

/// Reads a sensor file: of one lidar, as `read_lidar_model` does, or `name` and `lidars`, a list of such. Throws InputError at the key that
/// is wrong.
SensorRig read_sensor_rig(const std::filesystem::path& file);

/// The same for the text of a sensor file, as maps keep it; `file` is the name that errors show.
SensorRig parse_sensor_rig(const std::string& yaml, const std::filesystem::path& file);

}  // namespace alignability
