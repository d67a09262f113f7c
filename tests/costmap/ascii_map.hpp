// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <initializer_list>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "costmap/occupancy_map.hpp"

namespace alignability::test {

/// A map as drawn, the first line at the top: '#' occupied, '.' free, '?' unknown.
inline OccupancyMap ascii_map(double resolution, const std::vector<std::string>& lines,
                              const Eigen::Vector2d& origin = Eigen::Vector2d::Zero()) {
  const GridGeometry geometry{.resolution = resolution,
                              .origin = origin,
                              .width = static_cast<int>(lines.front().size()),
                              .height = static_cast<int>(lines.size())};
  Grid<float> occupancy(geometry, 0.0f);
  for (int y = 0; y < geometry.height; ++y) {
    const std::string& line = lines[static_cast<std::size_t>(geometry.height - 1 - y)];
    if (line.size() != lines.front().size()) throw std::invalid_argument("lines of a drawn map must be of one length");
    for (int x = 0; x < geometry.width; ++x) {
      const char drawn = line[static_cast<std::size_t>(x)];
      occupancy[Cell{x, y}] = drawn == '#' ? 1.0f : drawn == '.' ? 0.0f : std::numeric_limits<float>::quiet_NaN();
    }
  }
  return OccupancyMap(std::move(occupancy));
}

/// The drawing of a map, for a look at what differs.
inline std::vector<std::string> drawn(const OccupancyMap& map) {
  std::vector<std::string> lines;
  for (int y = map.geometry().height - 1; y >= 0; --y) {
    std::string line;
    for (int x = 0; x < map.geometry().width; ++x) {
      const auto occupancy = map.occupancy({x, y});
      line += !occupancy ? '?' : *occupancy > OccupancyMap::kOccupiedAbove ? '#' : '.';
    }
    lines.push_back(line);
  }
  return lines;
}

/// Each cell not free with that probability.
inline OccupancyMap random_map(std::mt19937_64& random, const GridGeometry& geometry, double density) {
  std::uniform_real_distribution<double> uniform;
  Grid<float> occupancy(geometry, 0.0f);
  for (std::size_t i = 0; i < geometry.size(); ++i) {
    if (uniform(random) < density) occupancy[i] = uniform(random) < 0.5 ? 1.0f : std::numeric_limits<float>::quiet_NaN();
  }
  return OccupancyMap(std::move(occupancy));
}

}  // namespace alignability::test
