// SPDX-License-Identifier: BSD-3-Clause
#include "planner/alpha_floor.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace alignability {
namespace {

constexpr int kLevels = 1000;
constexpr int kNone = -1;

int level_of(double alpha) { return std::isnan(alpha) ? kNone : static_cast<int>(std::floor(alpha * kLevels)); }

}  // namespace

std::optional<double> greatest_alpha_floor(const PlanarMotion& motion, const Eigen::Vector2d& start, const Eigen::Vector2d& goal) {
  const GridGeometry& map = motion.clearance->geometry();
  const GridGeometry corners{.resolution = map.resolution, .origin = map.origin, .width = map.width + 1, .height = map.height + 1};
  const auto alpha_at = [&](const Eigen::Vector2d& place) { return level_of(motion.risk->alpha(place.x(), place.y(), 0.0)); };
  std::vector<bool> reached(corners.size(), false);
  std::array<std::vector<std::size_t>, kLevels + 1> waiting;  // by the level that the way to them keeps
  const auto reach = [&](Cell cell, int level) {
    if (!corners.contains(cell) || reached[corners.index(cell)]) return;
    const Eigen::Vector2d place = corners.corner(cell);
    const int here = std::min(level, alpha_at(place));
    if (here == kNone || !motion.clearance->is_clear(place, motion.radius)) return;
    reached[corners.index(cell)] = true;
    waiting[static_cast<std::size_t>(here)].push_back(corners.index(cell));
  };
  const auto around = [&](const Eigen::Vector2d& place) {
    const Eigen::Array2i low = ((place - corners.origin) / corners.resolution).array().floor().cast<int>();
    return std::array{Cell{low.x(), low.y()}, Cell{low.x() + 1, low.y()}, Cell{low.x(), low.y() + 1}, Cell{low.x() + 1, low.y() + 1}};
  };
  const auto goals = around(goal);
  for (const Cell cell : around(start)) reach(cell, alpha_at(start));
  for (int level = kLevels; level >= 0; --level) {
    // What is reached from here keeps at most this level: it joins these, or waits for a lower one.
    std::vector<std::size_t>& here = waiting[static_cast<std::size_t>(level)];
    for (std::size_t i = 0; i < here.size(); ++i) {
      const Cell cell = corners.cell_of(here[i]);
      if (std::ranges::find(goals, cell) != goals.end()) {
        const int floor = std::min(level, alpha_at(goal));
        return floor == kNone ? std::nullopt : std::optional(static_cast<double>(floor) / kLevels);
      }
      for (const Cell next : {Cell{cell.x - 1, cell.y}, Cell{cell.x + 1, cell.y}, Cell{cell.x, cell.y - 1}, Cell{cell.x, cell.y + 1}}) {
        reach(next, level);
      }
    }
  }
  return std::nullopt;
}

}  // namespace alignability
