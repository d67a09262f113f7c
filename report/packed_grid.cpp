// SPDX-License-Identifier: BSD-3-Clause
#include "report/packed_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace alignability::detail {
namespace {

constexpr std::uint16_t kOne = 65534;
constexpr std::uint16_t kNoValue = 65535;

// How many cells a block of the other grid has on a side.
int cells_of(const GridGeometry& blocks, const GridGeometry& cells) {
  return std::max(1, static_cast<int>(std::lround(blocks.resolution / cells.resolution)));
}

}  // namespace

std::string to_base64(std::span<const std::uint8_t> bytes) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < count ? bytes[i + k] : 0u);
    for (std::size_t k = 0; k < 4; ++k) text += k <= count ? kDigits[group >> (18 - 6 * k) & 63u] : '=';
  }
  return text;
}

std::string packed_shares(const Grid<double>& values) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(2 * values.values().size());
  for (const double value : values.values()) {
    const std::uint16_t packed = std::isnan(value) ? kNoValue : static_cast<std::uint16_t>(std::lround(std::clamp(value, 0.0, 1.0) * kOne));
    bytes.push_back(static_cast<std::uint8_t>(packed & 255u));
    bytes.push_back(static_cast<std::uint8_t>(packed >> 8));
  }
  return to_base64(bytes);
}

std::string packed_occupancy(const OccupancyMap& occupancy) {
  const GridGeometry& cells = occupancy.geometry();
  std::vector<std::uint8_t> bytes((cells.size() + 3) / 4, 0);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const unsigned state = occupancy.is_free(i) ? 0u : occupancy.occupancy(cells.cell_of(i)) ? 2u : 1u;
    bytes[i / 4] = static_cast<std::uint8_t>(bytes[i / 4] | state << 2 * (i % 4));
  }
  return to_base64(bytes);
}

GridGeometry reduced(const GridGeometry& geometry, int most) {
  const int side = std::max({1, (geometry.width + most - 1) / most, (geometry.height + most - 1) / most});
  GridGeometry blocks = geometry;
  blocks.resolution *= side;
  blocks.width = (geometry.width + side - 1) / side;
  blocks.height = (geometry.height + side - 1) / side;
  return blocks;
}

Grid<double> least_by_block(const Grid<double>& values, const GridGeometry& blocks) {
  const GridGeometry& cells = values.geometry();
  const int side = cells_of(blocks, cells);
  Grid<double> least(blocks, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Cell cell = cells.cell_of(i);
    double& block = least[Cell{cell.x / side, cell.y / side}];
    block = std::fmin(block, values[i]);
  }
  return least;
}

OccupancyMap worst_by_block(const OccupancyMap& occupancy, const GridGeometry& blocks) {
  const GridGeometry& cells = occupancy.geometry();
  const int side = cells_of(blocks, cells);
  Grid<float> worst(blocks, 0.0f);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Cell cell = cells.cell_of(i);
    float& block = worst[Cell{cell.x / side, cell.y / side}];
    if (occupancy.is_free(i) || block == 1.0f) continue;
    block = occupancy.occupancy(cell) ? 1.0f : std::numeric_limits<float>::quiet_NaN();
  }
  return OccupancyMap(std::move(worst));
}

}  // namespace alignability::detail
