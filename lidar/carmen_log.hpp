// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "lidar/scan_log.hpp"

namespace alignability {

/// Whether a name is that of a CARMEN log: it ends in .log or .clf.
bool is_carmen_log(const std::filesystem::path& file);

/// The scans of a CARMEN log of a 2D lidar with the poses it has, line by line; other lines are passed over. `FLASER` lines are of 180
/// degrees, from right to left: an odd number of beams has one at either end, an even one has none at the left. `ROBOTLASER1` lines say
/// where their beams are. The pose is the first of the two on a line, that of the lidar, in the plane. Ranges that say that nothing came
/// back are NaN: 81.83 m and more of FLASER, which are a SICK LMS's codes, the largest range and more of ROBOTLASER1, and zero. A scan's
/// file is named with its line, `FILE:LINE`. Throws InputError at the value that is wrong: no number, NaN, a range below 0, a count of
/// beams that is not from 1 to 2^16 or not that of the values on the line, a pose beyond 1e7 m; and for a file without scans.
std::vector<PosedScan> read_carmen_log(const std::filesystem::path& file);

/// The same for a text; `file` is the name that errors show.
std::vector<PosedScan> parse_carmen_log(std::string_view text, const std::filesystem::path& file);

}  // namespace alignability
