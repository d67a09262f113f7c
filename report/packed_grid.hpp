// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "costmap/grid.hpp"
#include "costmap/occupancy_map.hpp"

namespace alignability::detail {

/// As RFC 4648 has it, padded.
std::string to_base64(std::span<const std::uint8_t> bytes);

/// Values in [0,1] as 16 bits each, little end first, 65534 for 1 and 65535 for NaN, in base64.
std::string packed_shares(const Grid<double>& values);

/// One bit a cell, the lowest first, in base64.
template <typename IsSet>
std::string packed_bits(std::size_t count, IsSet is_set) {
  std::vector<std::uint8_t> bytes((count + 7) / 8, 0);
  for (std::size_t i = 0; i < count; ++i) {
    if (is_set(i)) bytes[i / 8] = static_cast<std::uint8_t>(bytes[i / 8] | (1u << (i % 8)));
  }
  return to_base64(bytes);
}

/// Two bits a cell, the lowest first, in base64: 0 free, 1 unknown, 2 occupied.
std::string packed_occupancy(const OccupancyMap& occupancy);

/// The grid by blocks of as few cells as it takes for a side to have at most `most` of them.
GridGeometry reduced(const GridGeometry& geometry, int most);

/// By block the least value that is one; NaN where there is none.
Grid<double> least_by_block(const Grid<double>& values, const GridGeometry& blocks);
/// By block occupied where a cell is, else unknown where one is.
OccupancyMap worst_by_block(const OccupancyMap& occupancy, const GridGeometry& blocks);

}  // namespace alignability::detail
