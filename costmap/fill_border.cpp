// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <limits>
#include <optional>
#include <vector>

#include "costmap/risk_field.hpp"

namespace alignability {
namespace {

// The occupancy cells whose centres lie in a rectangle.
struct Window {
  Cell low;   // inclusive
  Cell high;  // exclusive

  int width() const { return std::max(0, high.x - low.x); }
  int height() const { return std::max(0, high.y - low.y); }
};

Window window_between(const GridGeometry& grid, const Eigen::Vector2d& low, const Eigen::Vector2d& high) {
  const auto first_at = [](double at, int cells) {
    return static_cast<int>(std::clamp(std::ceil(at - 0.5), 0.0, static_cast<double>(cells)));
  };
  const Eigen::Vector2d a = (low - grid.origin) / grid.resolution;
  const Eigen::Vector2d b = (high - grid.origin) / grid.resolution;
  return {{first_at(a.x(), grid.width), first_at(a.y(), grid.height)}, {first_at(b.x(), grid.width), first_at(b.y(), grid.height)}};
}

// The free cells of a window that belong together, numbered from 0; -1 = not free.
class FreeRegions {
 public:
  FreeRegions(const OccupancyMap& occupancy, const Window& window)
      : window_(window), labels_(static_cast<std::size_t>(window.width()) * static_cast<std::size_t>(window.height()), kNotFree) {
    for (int y = window.low.y; y < window.high.y; ++y) {
      for (int x = window.low.x; x < window.high.x; ++x) {
        if (occupancy.is_free(Cell{x, y}) && label({x, y}) == kNotFree) flood(occupancy, {x, y});
      }
    }
  }

  int count() const { return count_; }
  // Whether a region has a cell in this part of the window.
  bool has_cell_in(int region, const Window& part) const {
    for (int y = std::max(part.low.y, window_.low.y); y < std::min(part.high.y, window_.high.y); ++y) {
      for (int x = std::max(part.low.x, window_.low.x); x < std::min(part.high.x, window_.high.x); ++x) {
        if (label({x, y}) == region) return true;
      }
    }
    return false;
  }

 private:
  static constexpr int kNotFree = -1;

  int& label(Cell cell) { return labels_[index(cell)]; }
  int label(Cell cell) const { return labels_[index(cell)]; }
  std::size_t index(Cell cell) const {
    return static_cast<std::size_t>(cell.y - window_.low.y) * static_cast<std::size_t>(window_.width()) +
           static_cast<std::size_t>(cell.x - window_.low.x);
  }

  void flood(const OccupancyMap& occupancy, Cell seed) {
    std::vector<Cell> front{seed};
    label(seed) = count_;
    while (!front.empty()) {
      const Cell at = front.back();
      front.pop_back();
      for (const Cell next : {Cell{at.x - 1, at.y}, Cell{at.x + 1, at.y}, Cell{at.x, at.y - 1}, Cell{at.x, at.y + 1}}) {
        const bool inside = next.x >= window_.low.x && next.x < window_.high.x && next.y >= window_.low.y && next.y < window_.high.y;
        if (!inside || label(next) != kNotFree || !occupancy.is_free(next)) continue;
        label(next) = count_;
        front.push_back(next);
      }
    }
    ++count_;
  }

  Window window_;
  std::vector<int> labels_;
  int count_ = 0;
};

class BorderFill {
 public:
  BorderFill(const Grid<float>& alpha, const OccupancyMap& occupancy) : alpha_(alpha), occupancy_(occupancy) {}

  // The value for a cell that has none; NaN when no neighbour with a value is connected to it.
  double value(Cell cell) const {
    const std::vector<Cell> neighbours = evaluated_neighbours(cell);
    if (neighbours.empty()) return std::numeric_limits<double>::quiet_NaN();
    const FreeRegions regions(occupancy_, window_around(cell, 1));
    const auto within = [&](int region) { return regions.has_cell_in(region, window_around(cell, 0)); };
    if (const auto reached = mean_over(regions, neighbours, within)) return *reached;
    double lowest = std::numeric_limits<double>::infinity();
    for (int region = 0; region < regions.count(); ++region) {
      // Free, but cut off from every value: what lies behind a wall says nothing of this side.
      if (within(region)) return std::numeric_limits<double>::quiet_NaN();
      const auto side = mean_over(regions, neighbours, [&](int other) { return other == region; });
      if (side) lowest = std::min(lowest, *side);
    }
    return std::isfinite(lowest) ? lowest : std::numeric_limits<double>::quiet_NaN();
  }

 private:
  std::vector<Cell> evaluated_neighbours(Cell cell) const {
    std::vector<Cell> found;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const Cell at{cell.x + dx, cell.y + dy};
        if (alpha_.geometry().contains(at) && !std::isnan(alpha_[at])) found.push_back(at);
      }
    }
    return found;
  }

  Window window_around(Cell cell, int ring) const {
    const GridGeometry& grid = alpha_.geometry();
    return window_between(occupancy_.geometry(), grid.corner({cell.x - ring, cell.y - ring}),
                          grid.corner({cell.x + ring + 1, cell.y + ring + 1}));
  }

  // The mean over the neighbours that have a cell in one of the wanted regions; nullopt when none has.
  template <typename Wanted>
  std::optional<double> mean_over(const FreeRegions& regions, const std::vector<Cell>& neighbours, Wanted wanted) const {
    std::vector<int> chosen;
    for (int region = 0; region < regions.count(); ++region) {
      if (wanted(region)) chosen.push_back(region);
    }
    double sum = 0.0;
    int count = 0;
    for (const Cell neighbour : neighbours) {
      const Window part = window_around(neighbour, 0);
      if (std::ranges::none_of(chosen, [&](int region) { return regions.has_cell_in(region, part); })) continue;
      sum += alpha_[neighbour];
      ++count;
    }
    return count == 0 ? std::nullopt : std::optional(sum / count);
  }

  const Grid<float>& alpha_;
  const OccupancyMap& occupancy_;
};

}  // namespace

Grid<double> fill_border(const Grid<float>& alpha, const OccupancyMap& occupancy) {
  const BorderFill fill(alpha, occupancy);
  Grid<double> filled(alpha.geometry(), 0.0);
  for (std::size_t i = 0; i < alpha.values().size(); ++i) {
    filled[i] = std::isnan(alpha[i]) ? fill.value(alpha.geometry().cell_of(i)) : static_cast<double>(alpha[i]);
  }
  return filled;
}

}  // namespace alignability
