// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string_view>

#include "lidar/point_cloud.hpp"
#include "lidar/scan.hpp"

namespace alignability {

/// Reads the x, y, z of a PCD or PLY file, told apart by content, or of KITTI's and Velodyne's, which only the extension .bin and the
/// plausibility of their numbers tell. Of a PCD with HEIGHT > 1 the scan is organized: HEIGHT rings of WIDTH
/// columns. Points are given as they stand, fillers such as (0, 0, 0) included; VIEWPOINT is ignored. What a header declares is checked
/// against the file's length before anything is allocated. Throws InputError when the file is not well-formed, has more than 2^26 points or
/// has no x, y, z.
Scan read_scan_file(const std::filesystem::path& file);

/// The same points, with the normals that the file has: `normal_x` to `normal_z` in a PCD, `nx` to `nz` in a PLY.
PointCloud read_cloud_file(const std::filesystem::path& file);

/// Whether a file that begins with these bytes, 64 KiB or the whole of it, is one that `read_cloud_file` reads. A PLY with faces is none.
bool is_cloud_file(std::string_view head, const std::filesystem::path& file);

/// Writes a binary PCD, organized where the scan is, whole or not at all. Throws InputError naming `file` when that cannot be done.
void write_pcd(const Scan& scan, const std::filesystem::path& file);

}  // namespace alignability
