// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

namespace alignability {

/// What a line of a trajectory holds, told by how many values it has.
enum class TrajectoryFormat {
  tum,       ///< 8: stamp, x, y, z, and the quaternion qx, qy, qz, qw
  numbered,  ///< 9: the number of the scan, then the same
  kitti,     ///< 12: the upper three rows of the pose's matrix, row after row; the lines are numbered from 0
};

/// Where something was: its pose in `map`, a rigid motion.
struct TrajectoryPose {
  double stamp = 0.0;        ///< [s]; 0 in a KITTI trajectory, which has none
  std::uint64_t number = 0;  ///< of the scan; 0 in a TUM trajectory, which has none
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
};

struct Trajectory {
  std::filesystem::path file;
  TrajectoryFormat format = TrajectoryFormat::tum;
  std::vector<TrajectoryPose> poses;  ///< by stamp and by number ascending, as far as they have them
};

/// Reads a text file with a pose a line, values apart by blanks, `#` before comments. Throws InputError at the value that is wrong: no
/// number, NaN or beyond 1e7 m, a quaternion or a matrix that is further than 1e-3 from a rotation, a stamp or number that does not come
/// after the one before; where lines do not have the same number of values; and for a file without poses.
Trajectory read_trajectory(const std::filesystem::path& file);

/// The same for a text; `file` is the name that errors show.
Trajectory parse_trajectory(std::string_view text, const std::filesystem::path& file);

}  // namespace alignability
