// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "costmap/grey_image.hpp"

namespace alignability::detail {

struct PnmHeader {
  std::uint64_t width;
  std::uint64_t height;
  std::uint64_t brightest;  ///< the value of white, at most 65535
};

/// Both take bytes that begin as a PNM does, P1 to P6, and throw InputError, at the line and column where the file is text, for a header
/// that is none; the second where they end early or a value is above that of white, too. What `bytes` declare to be larger than they can
/// hold must not reach it.
PnmHeader read_pnm_header(const std::string& bytes, const std::filesystem::path& file);
GreyImage decode_pnm(const std::string& bytes, const std::filesystem::path& file);

}  // namespace alignability::detail
