// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string_view>

#include "lidar/scan.hpp"

namespace alignability::detail {

/// Reads the bytes of a PCD file, version 0.7: ascii, binary or binary_compressed. `file` is the name that errors show.
Scan parse_pcd(std::string_view bytes, const std::filesystem::path& file);

}  // namespace alignability::detail
