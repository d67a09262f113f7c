// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "lidar/scan.hpp"

namespace alignability {

/// Reads the x, y, z of a PCD or PLY file, told apart by content. Of a PCD with HEIGHT > 1 the scan is organized: HEIGHT rings of WIDTH
/// columns. Points are given as they stand, fillers such as (0, 0, 0) included; VIEWPOINT is ignored. What a header declares is checked
/// against the file's length before anything is allocated. Throws InputError when the file is not well-formed, has more than 2^26 points or
/// has no x, y, z.
Scan read_scan_file(const std::filesystem::path& file);

/// Writes a binary PCD, organized where the scan is, whole or not at all. Throws InputError naming `file` when that cannot be done.
void write_pcd(const Scan& scan, const std::filesystem::path& file);

}  // namespace alignability
